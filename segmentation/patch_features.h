#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

/// A vector for each patch from the distribution of fields on it: patches x (fields x levels). Of each field, level k
/// of n is the share of the patch's weight with a value among the least (k + 1/2) / n of the whole surface's weight: a
/// cumulative histogram whose bins hold equal shares of the surface. A few extreme values change it little, and any
/// increasing function of the field has the same. Values that are not finite do not count; a patch without any has the
/// whole surface's distribution.
///
/// `patch[i]`, from 0 on, is the patch of sample i. Throws InputError for less than one level, and
/// ArgumentError for no fields and a field that has not one value and one weight a sample.
Eigen::MatrixXd patch_features(std::span<const std::int32_t> patch, std::span<const ScalarField> fields, int levels);

}  // namespace shapegauge
