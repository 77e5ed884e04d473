#pragma once

#include <span>

#include "shapegauge/core/sdf/cone_sdf.h"

/// What cone_sdf() and its engines share. Not for users of the library. The engines are compiled apart: CGAL's flags
/// must not reach Embree's.
namespace shapegauge {

/// Mean of the values within 1.5 median absolute deviations of their median (as in CGAL 5.5). Of an even number of
/// values the median is the mean of the two in the middle. Sorts the values, of which there must be at least one.
double mean_without_outliers(std::span<double> values);

/// The cgal engine of cone_sdf(), which has checked the options: one value per triangle, on one thread. Throws
/// InputError where the triangles are no oriented manifold, which CGAL's mesh needs.
ConeSdfResult cone_sdf_cgal(const Shape& shape, const ConeSdfOptions& options);

/// The embree engine of cone_sdf(), which has checked the options and the samples.
ConeSdfResult cone_sdf_embree(const Shape& shape, const Samples& samples, const ConeSdfOptions& options);

}  // namespace shapegauge
