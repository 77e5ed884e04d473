#pragma once

#include <span>

#include "shapegauge/core/sdf/cone_sdf.h"

/// What the engines of cone_sdf() have between them. Not for users of the library.
namespace shapegauge {

/// Mean of the values that lie within 1.5 median absolute deviations of their median: what the conventional SDF makes
/// of the distances of its rays (CGAL 5.5). Both medians are the mean of the two in the middle where the values are
/// even in number. Sorts the values, of which there must be one at least.
double mean_without_outliers(std::span<double> values);

/// The cgal engine of cone_sdf(), which has checked the options: one value per triangle, on one thread. Throws
/// InputError where the triangles are no oriented manifold, which CGAL's mesh needs.
ConeSdfResult cone_sdf_cgal(const Shape& shape, const ConeSdfOptions& options);

/// The embree engine of cone_sdf(), which has checked the options and the samples.
ConeSdfResult cone_sdf_embree(const Shape& shape, const Samples& samples, const ConeSdfOptions& options);

}  // namespace shapegauge
