#include "tests/oracle/exterior_flood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace shapegauge {

namespace {

/// Up to this edge of a cube, in parts of r, the free points in it and the centres of the cubes around it are less than
/// 2r apart, so that no wall is between them.
constexpr double reliable_edge = 0.76;

bool is_open(const ExteriorNode& node) {
  return node.kind == CellKind::free || (node.kind == CellKind::mixed && node.clearance > 0);
}

/// Whether all of a segment lies outside of the offset solid, by halving it until balls of free space cover it.
bool segment_is_free(const OffsetExterior& exterior, const Eigen::Vector3d& a, const Eigen::Vector3d& b, int depth) {
  const Eigen::Vector3d middle = (a + b) / 2;
  const double half_length = (b - a).norm() / 2;
  const auto hit = exterior.tree().closest(middle, exterior.r() + half_length);
  if (!hit) return true;
  if (hit->distance <= exterior.r() || depth == 0) return false;
  return segment_is_free(exterior, a, middle, depth - 1) && segment_is_free(exterior, middle, b, depth - 1);
}

/// The straight way between two leaves of which one at least is mixed.
struct Way {
  FacePair pair;
  Eigen::Vector3d start, end;
  double start_clearance, end_clearance;  ///< radii of balls of free space about both
};

/// From the centre of a mixed leaf to that of the other, or only to the nearest point of one that is free all over.
Way way_between(const LeafGraph& graph, const std::vector<ExteriorNode>& nodes, const FacePair& pair) {
  const bool from_low = nodes[static_cast<std::size_t>(pair.low)].kind != CellKind::free;
  const std::int32_t from = from_low ? pair.low : pair.high;
  const std::int32_t to = from_low ? pair.high : pair.low;
  const ExteriorNode& other = nodes[static_cast<std::size_t>(to)];
  const bool is_free = other.kind == CellKind::free;
  const Eigen::Vector3d start = graph.centre(from);
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(is_free ? graph.half(to) : 0);
  const Eigen::Vector3d end = start.cwiseMax(graph.centre(to) - reach).cwiseMin(graph.centre(to) + reach);
  return {pair, start, end, static_cast<double>(nodes[static_cast<std::size_t>(from)].clearance),
          is_free ? 0 : static_cast<double>(other.clearance)};
}

/// Whether the balls about both ends meet: costs nothing.
bool is_free_at_once(const Way& way) {
  const double clearance = way.start_clearance + way.end_clearance;
  return clearance * clearance >= (way.end - way.start).squaredNorm();
}

/// Joins the leaves of those ways that are proven free. Takes a few neighbouring ones, whose middles are looked at
/// together.
void join_over(const OffsetExterior& exterior, std::span<const Way> ways, DisjointSets& parts) {
  constexpr int most_halvings = 2;
  std::array<Eigen::Vector3d, SurfaceTree::most_points_at_once> middles;
  double longest = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    middles[i] = (ways[i].start + ways[i].end) / 2;
    longest = std::max(longest, (ways[i].end - ways[i].start).norm() / 2);
  }
  const auto nearest = exterior.tree().closest_to_each(std::span(middles).first(ways.size()), exterior.r() + longest);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const auto& [pair, start, end, start_clearance, end_clearance] = ways[i];
    const double clearance = static_cast<double>(nearest[i].distance) - exterior.r();
    if (clearance <= 0 || parts.find(pair.low) == parts.find(pair.high)) continue;
    const double half_length = (end - start).norm() / 2;
    const bool is_free =
        (clearance + start_clearance >= half_length || segment_is_free(exterior, start, middles[i], most_halvings)) &&
        (clearance + end_clearance >= half_length || segment_is_free(exterior, middles[i], end, most_halvings));
    if (is_free) parts.join(pair.low, pair.high);
  }
}

/// Parts of a single leaf, whose centre is barely free, and to which larger parts they could lead.
class SteppingStones {
 public:
  SteppingStones(const std::vector<ExteriorNode>& nodes, const std::vector<FacePair>& pairs, DisjointSets& parts)
      : nodes_(nodes), parts_(parts), leaves_(nodes.size(), 0), leads_to_(nodes.size(), none) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (is_open(nodes[i])) ++leaves_[static_cast<std::size_t>(parts.find(static_cast<std::int32_t>(i)))];
    }
    stones_.grow_to(nodes.size());
    for (const FacePair& pair : pairs) {
      if (is_stone(pair.low) && is_stone(pair.high)) stones_.join(pair.low, pair.high);
    }
    for (const FacePair& pair : pairs) {
      lead(pair.low, pair.high);
      lead(pair.high, pair.low);
    }
  }

  /// Whether the leaf is a stone from which there is a way to one larger part only.
  bool is_dead_end(std::int32_t leaf) { return is_stone(leaf) && larger_part(leaf) >= 0; }

  /// The larger part that all ways from a stone lead to.
  std::int32_t larger_part(std::int32_t stone) { return leads_to_[static_cast<std::size_t>(stones_.find(stone))]; }

 private:
  static constexpr std::int32_t none = -1;
  static constexpr std::int32_t several = -2;

  bool is_stone(std::int32_t leaf) {
    const auto part = static_cast<std::size_t>(parts_.find(leaf));
    return leaves_[part] == 1 && nodes_[part].kind == CellKind::mixed;
  }

  void lead(std::int32_t from, std::int32_t to) {
    if (!is_stone(from) || is_stone(to)) return;
    const std::int32_t part = parts_.find(to);
    std::int32_t& known = leads_to_[static_cast<std::size_t>(stones_.find(from))];
    known = known == none || known == part ? part : several;
  }

  const std::vector<ExteriorNode>& nodes_;
  DisjointSets& parts_;
  std::vector<std::int32_t> leaves_;  ///< of the part whose least leaf it is
  DisjointSets stones_;
  std::vector<std::int32_t> leads_to_;  ///< of sets of neighbouring stones
};

/// The pairs that could join two larger parts. Stepping stones that could lead to one such part only are joined to it
/// without a proof (two free points so near each other have no wall between them, which would be 2r thick). Stones
/// among themselves may be a pocket, and stay.
std::vector<FacePair> with_dead_ends_joined(const std::vector<ExteriorNode>& nodes, const std::vector<FacePair>& pairs,
                                            DisjointSets& parts) {
  SteppingStones stones(nodes, pairs, parts);
  std::vector<FacePair> kept;
  std::vector<std::int32_t> dead_ends;
  for (const FacePair& pair : pairs) {
    const bool low = stones.is_dead_end(pair.low);
    const bool high = stones.is_dead_end(pair.high);
    if (low) dead_ends.push_back(pair.low);
    if (high) dead_ends.push_back(pair.high);
    if (!low && !high) kept.push_back(pair);
  }
  for (const std::int32_t leaf : dead_ends) parts.join(leaf, stones.larger_part(leaf));
  return kept;
}

/// Joins the open leaves across faces where the way is proven free: the proofs that cost nothing first, the others only
/// where they would join different parts.
/// Ways between two of the first `tried` nodes were tried before.
void join_leaves(const OffsetExterior& exterior, const LeafGraph& graph, std::int32_t tried, DisjointSets& parts) {
  const std::vector<ExteriorNode>& nodes = exterior.nodes();
  std::vector<FacePair> uncertain;
  const auto join_or_keep = [&](const FacePair& pair) {
    if (pair.low < tried && pair.high < tried) return;
    const ExteriorNode& low = nodes[static_cast<std::size_t>(pair.low)];
    const ExteriorNode& high = nodes[static_cast<std::size_t>(pair.high)];
    if (!is_open(low) || !is_open(high)) return;
    const bool are_free = low.kind == CellKind::free && high.kind == CellKind::free;
    if (are_free || is_free_at_once(way_between(graph, nodes, pair))) {
      parts.join(pair.low, pair.high);
    } else {
      uncertain.push_back(pair);
    }
  };
  for (int axis = 0; axis < 3; ++axis) std::ranges::for_each(graph.pairs(axis), join_or_keep);
  // Only a closed surface has another way to decide what becomes of a pocket. Neighbouring centres are less than 2r
  // apart.
  if (exterior.is_closed() && exterior.resolution() <= exterior.r())
    uncertain = with_dead_ends_joined(nodes, uncertain, parts);
  std::vector<Way> together;
  for (const FacePair& pair : uncertain) {
    if (parts.find(pair.low) == parts.find(pair.high)) continue;
    together.push_back(way_between(graph, nodes, pair));
    if (together.size() < SurfaceTree::most_points_at_once) continue;
    join_over(exterior, together, parts);
    together.clear();
  }
  join_over(exterior, together, parts);
}

/// What is known of a connected part of the free space.
struct PartSummary {
  std::int32_t representative = -1;  ///< the leaf whose centre is farthest from the surface
  float clearance = -1;
  bool holds_free_cube = false;
};

std::vector<PartSummary> summarise(const std::vector<ExteriorNode>& nodes, DisjointSets& parts) {
  std::vector<PartSummary> summaries(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_open(nodes[i])) continue;
    PartSummary& summary = summaries[static_cast<std::size_t>(parts.find(static_cast<std::int32_t>(i)))];
    const bool free = nodes[i].kind == CellKind::free;
    const float clearance = free ? std::numeric_limits<float>::infinity() : nodes[i].clearance;
    summary.holds_free_cube |= free;
    if (clearance <= summary.clearance) continue;
    summary.clearance = clearance;
    summary.representative = static_cast<std::int32_t>(i);
  }
  return summaries;
}

/// Of a part that the flood did not reach. On which side of a closed surface it lies, the crossings of a ray tell.
FreeSpace space_of_part(const PartSummary& summary, std::optional<bool> outside) {
  if (summary.holds_free_cube) return FreeSpace::enclosed;
  if (!outside) return FreeSpace::none;
  return *outside ? FreeSpace::exterior : FreeSpace::enclosed;
}

/// Adds the leaves that share a face with those given.
void grow(std::vector<bool>& given, const LeafGraph& graph) {
  const std::vector<bool> before = given;
  for (int axis = 0; axis < 3; ++axis) {
    for (const FacePair& pair : graph.pairs(axis)) {
      const auto low = static_cast<std::size_t>(pair.low);
      const auto high = static_cast<std::size_t>(pair.high);
      if (before[low]) given[high] = true;
      if (before[high]) given[low] = true;
    }
  }
}

FreeSpace merged(FreeSpace a, FreeSpace b) {
  if (a == FreeSpace::none || a == b) return b;
  return b == FreeSpace::none ? a : FreeSpace::both;
}

/// Gives each of the small leaves the spaces of its surroundings, a cube wide, one axis after the other. Larger solid
/// leaves do not pass anything on: that would reach through the surface.
void spread_to_mixed(const LeafGraph& graph, double resolution, std::vector<ExteriorNode>& nodes) {
  for (ExteriorNode& node : nodes) node.space = node.centre_space;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<FreeSpace> before(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) before[i] = nodes[i].space;
    const auto spread = [&](std::int32_t from, std::int32_t to) {
      ExteriorNode& node = nodes[static_cast<std::size_t>(to)];
      if (node.kind == CellKind::free || 2 * graph.half(to) > 1.5 * resolution) return;
      node.space = merged(node.space, before[static_cast<std::size_t>(from)]);
    };
    for (const FacePair& pair : graph.pairs(axis)) {
      spread(pair.low, pair.high);
      spread(pair.high, pair.low);
    }
  }
}

/// Where small leaves are larger than that, what surrounds them may lie beyond a wall: points in them have to climb.
void doubt_large_leaves(const LeafGraph& graph, double largest, std::vector<ExteriorNode>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool is_large = 2 * graph.half(static_cast<std::int32_t>(i)) > largest;
    if (nodes[i].kind == CellKind::mixed && is_large) nodes[i].space = FreeSpace::both;
  }
}

/// Settles by a ray's crossings what the surroundings of a mixed leaf leave open. All free points in the leaf are on
/// the side of its centre where that is within r of them: no surface passes between.
/// Points in leaves that are outside though nothing around them was reached have to climb.
void settle_by_crossings(const OffsetExterior& exterior, const LeafGraph& graph, std::vector<ExteriorNode>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ExteriorNode& node = nodes[i];
    const bool open = node.space == FreeSpace::none || node.space == FreeSpace::both;
    if (node.kind != CellKind::mixed || !open) continue;
    const auto leaf = static_cast<std::int32_t>(i);
    if (std::sqrt(3.0) * graph.half(leaf) >= exterior.r()) continue;
    const auto outside = exterior.is_outside_by_crossings(graph.centre(leaf));
    if (!outside) continue;
    if (!*outside) {
      node.space = FreeSpace::enclosed;
    } else if (node.space == FreeSpace::none) {
      node.space = FreeSpace::both;
    }
  }
}

/// Encloses the mixed leaves of which nothing is known and from which no way, however narrow, leads to the exterior:
/// past solid leaves they have only each other and enclosed ones around them.
void enclose_dead_ends(const LeafGraph& graph, std::vector<ExteriorNode>& nodes) {
  const auto node = [&](std::int32_t leaf) -> ExteriorNode& { return nodes[static_cast<std::size_t>(leaf)]; };
  const auto is_unknown = [](const ExteriorNode& leaf) {
    return leaf.kind == CellKind::mixed && leaf.space == FreeSpace::none;
  };
  const auto may_be_exterior = [](const ExteriorNode& leaf) {
    return leaf.kind != CellKind::solid && (leaf.space == FreeSpace::exterior || leaf.space == FreeSpace::both);
  };
  DisjointSets regions;
  regions.grow_to(nodes.size());
  std::vector<char> leads_out(nodes.size(), 0);
  for (int axis = 0; axis < 3; ++axis) {
    for (const FacePair& pair : graph.pairs(axis)) {
      if (is_unknown(node(pair.low)) && is_unknown(node(pair.high))) regions.join(pair.low, pair.high);
    }
  }
  const auto lead = [&](std::int32_t from, std::int32_t to) {
    if (is_unknown(node(from)) && may_be_exterior(node(to)))
      leads_out[static_cast<std::size_t>(regions.find(from))] = 1;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const FacePair& pair : graph.pairs(axis)) {
      lead(pair.low, pair.high);
      lead(pair.high, pair.low);
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool unknown = is_unknown(nodes[i]);
    if (!unknown || leads_out[static_cast<std::size_t>(regions.find(static_cast<std::int32_t>(i)))] != 0) continue;
    nodes[i].space = FreeSpace::enclosed;
    if (is_open(nodes[i])) nodes[i].centre_space = FreeSpace::enclosed;
  }
}

}  // namespace

void ExteriorFlood::run(const OffsetExterior& exterior, std::vector<ExteriorNode>& nodes) {
  join(exterior);
  label(exterior, nodes);
}

void ExteriorFlood::join(const OffsetExterior& exterior) {
  const std::vector<ExteriorNode>& nodes = exterior.nodes();
  graph_ = LeafGraph(exterior);
  const auto tried = static_cast<std::int32_t>(parts_.size());
  parts_.grow_to(nodes.size());
  join_leaves(exterior, graph_, tried, parts_);
  const std::vector<PartSummary> summaries = summarise(nodes, parts_);
  const ExteriorCell root = exterior.root();
  const auto corner = exterior.leaf_at(root.centre - 0.999 * Eigen::Vector3d::Constant(root.half));
  const auto reached = static_cast<std::size_t>(parts_.find(corner->node));
  spaces_.assign(nodes.size(), FreeSpace::none);
  leads_nowhere_.assign(nodes.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i == reached || summaries[i].representative < 0) continue;
    const auto is_outside = exterior.is_outside_by_crossings(graph_.centre(summaries[i].representative));
    leads_nowhere_[i] = is_outside == true;
    spaces_[i] = space_of_part(summaries[i], is_outside);
  }
  spaces_[reached] = FreeSpace::exterior;
}

void ExteriorFlood::label(const OffsetExterior& exterior, std::vector<ExteriorNode>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].centre_space = FreeSpace::none;
    if (!is_open(nodes[i])) continue;
    const auto part = static_cast<std::size_t>(parts_.find(static_cast<std::int32_t>(i)));
    nodes[i].centre_space = spaces_[part];
    leads_nowhere_[i] = leads_nowhere_[part];
  }
  spread_to_mixed(graph_, exterior.resolution(), nodes);
  if (exterior.is_closed()) doubt_large_leaves(graph_, reliable_edge * exterior.r(), nodes);
  settle_by_crossings(exterior, graph_, nodes);
  if (!exterior.is_closed()) enclose_dead_ends(graph_, nodes);
}

std::vector<ExteriorCell> ExteriorFlood::possible_passages(const OffsetExterior& exterior) const {
  if (std::ranges::find(leads_nowhere_, true) == leads_nowhere_.end()) return {};
  constexpr int reach = 3;  // faces
  std::vector<bool> is_near = leads_nowhere_;
  for (int step = 0; step < reach; ++step) grow(is_near, graph_);
  std::vector<ExteriorCell> found;
  for (std::size_t i = 0; i < is_near.size(); ++i) {
    const auto leaf = static_cast<std::int32_t>(i);
    const bool is_small = 2 * graph_.half(leaf) < 1.5 * exterior.resolution();
    if (!is_near[i] || !is_small || exterior.nodes()[i].kind != CellKind::mixed) continue;
    found.push_back({graph_.centre(leaf), graph_.half(leaf), leaf});
  }
  return found;
}

}  // namespace shapegauge
