#include "shapegauge/core/shape/merged_vertices.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace shapegauge {

std::vector<std::int32_t> merged_by_place(const Points& vertices) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(vertices.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::int32_t i) { return std::array{vertices(i, 0), vertices(i, 1), vertices(i, 2)}; };
  std::sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
    const auto left = key(i);
    const auto right = key(j);
    return left != right ? left < right : i < j;
  });
  std::vector<std::int32_t> merged(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && key(order[k]) == key(order[k - 1]);
    merged[static_cast<std::size_t>(order[k])] = same ? merged[static_cast<std::size_t>(order[k - 1])] : order[k];
  }
  return merged;
}

}  // namespace shapegauge
