// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "shapegauge/core/sdf/cone_sdf.h"

/// Implementation of cone_sdf(), shared by its engines; not part of the public interface. The engines are compiled
/// separately: CGAL's flags must not affect Embree's.
namespace shapegauge {

/// Returns the mean of the values within 1.5 median absolute deviations of their median (as CGAL 5.5 does). For an even
/// count the median is the mean of the two middle values. Sorts the values. Needs at least one value.
double mean_without_outliers(std::span<double> values);

/// Computes cone_sdf() with the engine cgal, for validated options: one value per triangle, on one thread. Throws
/// InputError if the triangles do not form an oriented manifold.
ConeSdfResult cone_sdf_cgal(const Shape& shape, const ConeSdfOptions& options);

/// Computes cone_sdf() with the engine embree, for validated options and samples.
ConeSdfResult cone_sdf_embree(const Shape& shape, const Samples& samples, const ConeSdfOptions& options);

}  // namespace shapegauge
