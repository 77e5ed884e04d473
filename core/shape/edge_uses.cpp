#include "shapegauge/core/shape/edge_uses.h"

#include <algorithm>
#include <array>

namespace shapegauge {

std::vector<EdgeUse> edge_uses(const Triangles& triangles, std::span<const std::int32_t> merged) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    std::array<std::int32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = merged[static_cast<std::size_t>(triangles(f, static_cast<Eigen::Index>(k)))];
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = corners[k];
      const std::int32_t to = corners[(k + 1) % 3];
      uses.push_back({.low = std::min(from, to),
                      .high = std::max(from, to),
                      .triangle = static_cast<std::int32_t>(f),
                      .corner = static_cast<std::int8_t>(k),
                      .forward = from < to});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return uses;
}

}  // namespace shapegauge
