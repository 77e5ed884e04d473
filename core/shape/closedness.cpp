#include "shapegauge/core/shape/closedness.h"

#include "shapegauge/core/shape/edge_uses.h"
#include "shapegauge/core/shape/merged_vertices.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

bool is_closed(const Shape& shape) {
  require_usable(shape);
  const std::vector<EdgeUse> uses = edge_uses(shape.triangles, merged_by_place(shape.vertices));
  bool closed = !uses.empty();
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) { closed = closed && edge.size() % 2 == 0; });
  return closed;
}

}  // namespace shapegauge
