#include "shapegauge/core/shape/closedness.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

namespace {

/// For each vertex the first vertex at the same place.
std::vector<std::int32_t> merged_by_place(const Points& vertices) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(vertices.rows()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(i);
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

}  // namespace

bool is_closed(const Shape& shape) {
  require_usable(shape);
  if (shape.triangles.rows() == 0) return false;
  const std::vector<std::int32_t> merged = merged_by_place(shape.vertices);
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  edges.reserve(3 * static_cast<std::size_t>(shape.triangles.rows()));
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    std::array<std::int32_t, 3> corner{};
    for (int k = 0; k < 3; ++k)
      corner[static_cast<std::size_t>(k)] = merged[static_cast<std::size_t>(shape.triangles(f, k))];
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::minmax({corner[k], corner[(k + 1) % 3]}));
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    const auto end = std::upper_bound(edges.begin() + static_cast<std::ptrdiff_t>(i), edges.end(), edges[i]);
    const auto next = static_cast<std::size_t>(end - edges.begin());
    if ((next - i) % 2 != 0) return false;
    i = next;
  }
  return !edges.empty();
}

}  // namespace shapegauge
