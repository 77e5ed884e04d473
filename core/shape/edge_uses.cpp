#include "shapegauge/core/shape/edge_uses.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace shapegauge {

namespace {

/// The uses by (low, high, triangle), of which they are by triangle already: counted into their low vertices' places,
/// which hold few each.
std::vector<EdgeUse> sorted(const std::vector<EdgeUse>& uses, std::size_t vertices) {
  std::vector<std::size_t> begin(vertices + 1, 0);
  for (const EdgeUse& use : uses) ++begin[static_cast<std::size_t>(use.low) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<EdgeUse> result(uses.size());
  std::vector<std::size_t> next = begin;
  for (const EdgeUse& use : uses) result[next[static_cast<std::size_t>(use.low)]++] = use;
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto place = [&](std::size_t i) { return result.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(place(begin[v]), place(begin[v + 1]), [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
    });
  }
  return result;
}

}  // namespace

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
  return sorted(uses, merged.size());
}

}  // namespace shapegauge
