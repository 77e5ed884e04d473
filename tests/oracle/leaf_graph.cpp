#include "tests/oracle/leaf_graph.h"

namespace shapegauge {

namespace {

const ExteriorNode& node_at(const std::vector<ExteriorNode>& nodes, std::int32_t index) {
  return nodes[static_cast<std::size_t>(index)];
}

}  // namespace

LeafGraph::LeafGraph(const OffsetExterior& exterior)
    : centres_(exterior.nodes().size()), halves_(exterior.nodes().size()) {
  for (auto& pairs : pairs_) pairs.reserve(exterior.nodes().size());
  visit(exterior.nodes(), exterior.root());
}

void LeafGraph::visit(const Nodes& nodes, const ExteriorCell& cell) {
  centres_[static_cast<std::size_t>(cell.node)] = cell.centre;
  halves_[static_cast<std::size_t>(cell.node)] = cell.half;
  if (node_at(nodes, cell.node).kind != CellKind::divided) return;
  const std::int32_t first = node_at(nodes, cell.node).first_child;
  for (int i = 0; i < 8; ++i) visit(nodes, OffsetExterior::octant(cell, i, first + i));
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 8; ++i) {
      if ((i & (1 << axis)) == 0) pair(nodes, first + i, first + (i | (1 << axis)), axis);
    }
  }
}

void LeafGraph::pair(const Nodes& nodes, std::int32_t low, std::int32_t high, int axis) {
  const bool low_divided = node_at(nodes, low).kind == CellKind::divided;
  const bool high_divided = node_at(nodes, high).kind == CellKind::divided;
  if (!low_divided && !high_divided) {
    pairs_[static_cast<std::size_t>(axis)].push_back({low, high, axis});
    return;
  }
  for (int i = 0; i < 8; ++i) {
    if ((i & (1 << axis)) != 0) continue;
    pair(nodes, low_divided ? node_at(nodes, low).first_child + (i | (1 << axis)) : low,
         high_divided ? node_at(nodes, high).first_child + i : high, axis);
  }
}

}  // namespace shapegauge
