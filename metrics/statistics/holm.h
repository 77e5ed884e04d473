#pragma once

#include <span>
#include <vector>

namespace shapegauge {

/// The p-values of several tests, adjusted so that calling those below alpha significant goes wrong anywhere with a
/// probability of at most alpha, whatever depends on what: with p-values in ascending order, the i-th of m becomes the
/// largest of (m - j + 1) p_j for j <= i, at most 1. Holm, "A simple sequentially rejective multiple test procedure",
/// Scandinavian Journal of Statistics 6, 1979.
std::vector<double> holm_adjusted(std::span<const double> p_values);

}  // namespace shapegauge
