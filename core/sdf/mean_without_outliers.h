#pragma once

#include <span>

namespace shapegauge {

/// Mean of the values that lie within 1.5 median absolute deviations of their median: what the conventional SDF makes
/// of the distances of its rays (CGAL 5.5). Both medians are the mean of the two in the middle where the values are
/// even in number. Sorts the values, of which there must be one at least.
double mean_without_outliers(std::span<double> values);

}  // namespace shapegauge
