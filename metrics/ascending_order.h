// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shapegauge {

/// Returns the indices that sort a vector or span in ascending order; equal values keep their order.
template <typename Values>
std::vector<std::size_t> ascending_order(const Values& values) {
  using Index = decltype(values.size());
  std::vector<std::size_t> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[static_cast<Index>(i)]; });
  return order;
}

}  // namespace shapegauge
