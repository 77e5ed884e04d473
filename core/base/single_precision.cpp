// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/single_precision.h"

#include <algorithm>
#include <compare>
#include <numeric>
#include <vector>

namespace shapegauge {

namespace {

double rounded(double number) { return static_cast<double>(static_cast<float>(number)); }

std::partial_ordering compare_rounded(std::span<const double> a, std::span<const double> b) {
  return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end(),
                                                [](double x, double y) { return rounded(x) <=> rounded(y); });
}

}  // namespace

std::size_t rows_merged_in_single_precision(std::span<const double> numbers, std::size_t columns) {
  if (std::ranges::all_of(numbers, [](double x) { return rounded(x) == x; })) return 0;
  std::vector<std::size_t> order(numbers.size() / columns);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto row = [&](std::size_t i) { return numbers.subspan(i * columns, columns); };
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    const auto by_rounded = compare_rounded(row(i), row(j));
    return std::is_lt(by_rounded) || (std::is_eq(by_rounded) && std::ranges::lexicographical_compare(row(i), row(j)));
  });
  std::size_t merged = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::span<const double> a = row(order[k - 1]);
    const std::span<const double> b = row(order[k]);
    if (std::is_eq(compare_rounded(a, b)) && !std::ranges::equal(a, b)) ++merged;
  }
  return merged;
}

}  // namespace shapegauge
