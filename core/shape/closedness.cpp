#include "shapegauge/core/shape/closedness.h"

#include <algorithm>

#include "shapegauge/core/shape/edge_uses.h"
#include "shapegauge/core/shape/merged_vertices.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

namespace {

/// Whether there are edges, and all of them satisfy a condition.
template <typename Condition>
bool all_edges(const Shape& shape, Condition condition) {
  require_usable(shape);
  const std::vector<EdgeUse> uses = edge_uses(shape.triangles, merged_by_place(shape.vertices));
  bool all = !uses.empty();
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) { all = all && condition(edge); });
  return all;
}

}  // namespace

bool is_closed(const Shape& shape) {
  return all_edges(shape, [](std::span<const EdgeUse> edge) { return edge.size() % 2 == 0; });
}

bool is_closed_and_oriented(const Shape& shape) {
  return all_edges(shape, [](std::span<const EdgeUse> edge) {
    return 2 * std::ranges::count(edge, true, &EdgeUse::forward) == std::ssize(edge);
  });
}

}  // namespace shapegauge
