// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

/// Computes a feature vector for each patch from the distribution of fields on it: patches x (fields x levels). Level k
/// of n is the share of the patch's weight whose values are below the (k + 1/2) / n quantile of the whole surface. It
/// is a cumulative histogram whose bins hold equal shares of the surface, robust to extreme values and invariant to
/// increasing functions of the field. Values that are not finite are ignored; a patch without any has the distribution
/// of the whole surface.
///
/// `patch[i]`, from 0 on, is the patch of sample i. Throws InputError for less than one level, and ArgumentError
/// without fields and for a field whose size differs from that of `patch`.
Eigen::MatrixXd patch_features(std::span<const std::int32_t> patch, std::span<const ScalarField> fields, int levels);

}  // namespace shapegauge
