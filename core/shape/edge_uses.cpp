#include "shapegauge/core/shape/edge_uses.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "shapegauge/core/shape/counting_sort.h"

namespace shapegauge {

namespace {

/// The uses by (low, high, triangle).
std::vector<EdgeUse> sorted(const std::vector<EdgeUse>& uses, std::size_t vertices) {
  CountedByKey<EdgeUse> counted = counted_by_key(uses, vertices, [](const EdgeUse& use) { return use.low; });
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto place = [&](std::size_t i) { return counted.values.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(place(counted.first[v]), place(counted.first[v + 1]), [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
    });
  }
  return std::move(counted.values);
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
