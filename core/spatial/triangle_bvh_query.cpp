// SPDX-License-Identifier: GPL-3.0-or-later
// Hot loops of the surface tree, compiled once for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/spatial/triangle_bvh_query.cpp"
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>

#include "shapegauge/core/spatial/triangle_bvh_layout.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Sufficient for 2^31 triangles in nodes of eight, with all siblings waiting at every level.
constexpr int stack_size = 256;

/// Node or leaf to visit.
struct Waiting {
  float squared_distance;
  std::int32_t child;
};

template <typename D>
using VectorOf = std::array<hn::Vec<D>, 3>;

template <typename D>
HWY_INLINE hn::Vec<D> dot(const VectorOf<D>& u, const VectorOf<D>& v) {
  return hn::MulAdd(u[0], v[0], hn::MulAdd(u[1], v[1], hn::Mul(u[2], v[2])));
}

template <typename D>
HWY_INLINE VectorOf<D> load(D d, const LeafVector& vectors, std::size_t lane) {
  return {hn::Load(d, vectors[0].data() + lane), hn::Load(d, vectors[1].data() + lane),
          hn::Load(d, vectors[2].data() + lane)};
}

template <typename D>
HWY_INLINE VectorOf<D> subtract(const VectorOf<D>& u, const VectorOf<D>& v) {
  return {hn::Sub(u[0], v[0]), hn::Sub(u[1], v[1]), hn::Sub(u[2], v[2])};
}

/// Returns the squared distance from the point at v, relative to the edge's start, to the edge.
template <typename D>
HWY_INLINE hn::Vec<D> to_edge(D d, const VectorOf<D>& v, const VectorOf<D>& edge, hn::Vec<D> inverse) {
  const auto t = hn::Min(hn::Max(hn::Mul(dot<D>(v, edge), inverse), hn::Zero(d)), hn::Set(d, 1.0F));
  const VectorOf<D> rest = {hn::NegMulAdd(t, edge[0], v[0]), hn::NegMulAdd(t, edge[1], v[1]),
                            hn::NegMulAdd(t, edge[2], v[2])};
  return dot<D>(rest, rest);
}

/// Computes the squared distances from x to the leaf's triangles: to the plane if x projects into the triangle,
/// otherwise to the nearest edge. Returns the smallest.
HWY_INLINE float squared_distances(const TriangleBvhLeaf& leaf, const Eigen::Vector3d& x, LeafLane& result) {
  const hn::CappedTag<float, triangles_per_leaf> d;
  auto smallest = hn::Set(d, std::numeric_limits<float>::infinity());
  const Eigen::Vector3f local = (x - leaf.origin).cast<float>();
  const VectorOf<decltype(d)> point = {hn::Set(d, local[0]), hn::Set(d, local[1]), hn::Set(d, local[2])};
  for (std::size_t lane = 0; lane < triangles_per_leaf; lane += hn::Lanes(d)) {
    const auto ab = load(d, leaf.ab, lane);
    const auto ac = load(d, leaf.ac, lane);
    const auto from_a = subtract<decltype(d)>(point, load(d, leaf.a, lane));
    const auto from_b = subtract<decltype(d)>(from_a, ab);
    auto nearest = to_edge(d, from_a, ab, hn::Load(d, leaf.inverse_ab.data() + lane));
    nearest = hn::Min(nearest, to_edge(d, from_a, ac, hn::Load(d, leaf.inverse_ac.data() + lane)));
    nearest =
        hn::Min(nearest, to_edge(d, from_b, subtract<decltype(d)>(ac, ab), hn::Load(d, leaf.inverse_bc.data() + lane)));
    const auto height = dot<decltype(d)>(from_a, load(d, leaf.normal, lane));
    const auto b = dot<decltype(d)>(from_a, load(d, leaf.dual_b, lane));
    const auto c = dot<decltype(d)>(from_a, load(d, leaf.dual_c, lane));
    const auto zero = hn::Zero(d);
    const auto inside = hn::And(hn::And(hn::Ge(b, zero), hn::Ge(c, zero)), hn::Le(hn::Add(b, c), hn::Set(d, 1.0F)));
    const auto squared = hn::IfThenElse(inside, hn::Mul(height, height), nearest);
    hn::Store(squared, d, result.data() + lane);
    smallest = hn::Min(smallest, squared);
  }
  return hn::GetLane(hn::MinOfLanes(d, smallest));
}

/// Returns the triangle of the leaf closest to x if its squared distance is below the limit, which is then lowered;
/// otherwise -1.
HWY_INLINE std::int32_t closest_in_leaf(const TriangleBvhLeaf& leaf, const Eigen::Vector3d& x, float& limit) {
  alignas(64) LeafLane distances;
  const float smallest = squared_distances(leaf, x, distances);
  if (!(smallest < limit)) return -1;
  limit = smallest;
  for (std::size_t lane = 0;; ++lane) {
    if (distances[lane] == smallest) return leaf.triangle[lane];
  }
}

/// Computes the squared distances from x to the boxes of the node's children or to their disks, whichever are larger.
/// Returns a bit mask of those below the limit.
HWY_INLINE std::uint32_t squared_distances(const TriangleBvhNode& node, const Eigen::Vector3f& x, float limit,
                                           std::array<float, children_per_node>& result) {
  const hn::CappedTag<float, children_per_node> d;
  std::uint32_t below_limit = 0;
  for (std::size_t lane = 0; lane < children_per_node; lane += hn::Lanes(d)) {
    auto sum = hn::Zero(d);
    auto height = hn::Zero(d);
    auto from_centre2 = hn::Zero(d);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto coordinate = hn::Set(d, x[static_cast<Eigen::Index>(k)]);
      const auto from_centre = hn::Sub(coordinate, hn::Load(d, node.centre[k].data() + lane));
      height = hn::MulAdd(from_centre, hn::Load(d, node.normal[k].data() + lane), height);
      from_centre2 = hn::MulAdd(from_centre, from_centre, from_centre2);
      const auto below = hn::Sub(hn::Load(d, node.low[k].data() + lane), coordinate);
      const auto above = hn::Sub(coordinate, hn::Load(d, node.high[k].data() + lane));
      const auto outside = hn::Max(hn::Max(below, above), hn::Zero(d));
      sum = hn::MulAdd(outside, outside, sum);
    }
    const auto off_axis = hn::Sqrt(hn::Max(hn::NegMulAdd(height, height, from_centre2), hn::Zero(d)));
    const auto above = hn::Max(hn::Sub(hn::Abs(height), hn::Load(d, node.half_height.data() + lane)), hn::Zero(d));
    const auto radial = hn::Max(hn::Sub(off_axis, hn::Load(d, node.radius.data() + lane)), hn::Zero(d));
    sum = hn::Max(sum, hn::MulAdd(above, above, hn::Mul(radial, radial)));
    hn::Store(sum, d, result.data() + lane);
    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(d, hn::Lt(sum, hn::Set(d, limit)), bits.data());
    below_limit |= static_cast<std::uint32_t>(bits[0]) << lane;
  }
  return below_limit;
}

/// Pushes the children nearer than the limit on the stack, the nearest on top.
HWY_INLINE int push_children(const TriangleBvhNode& node, const Eigen::Vector3f& x, float squared_limit,
                             std::array<Waiting, stack_size>& stack, int top) {
  alignas(64) std::array<float, children_per_node> distances;
  const int bottom = top;
  for (std::uint32_t left = squared_distances(node, x, squared_limit, distances); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    int slot = top++;
    for (; slot > bottom && stack[static_cast<std::size_t>(slot - 1)].squared_distance < distances[i]; --slot) {
      stack[static_cast<std::size_t>(slot)] = stack[static_cast<std::size_t>(slot - 1)];
    }
    stack[static_cast<std::size_t>(slot)] = {distances[i], node.child[i]};
  }
  return top;
}

/// Visits leaves from near to far; the visitor gets a leaf and the limit, which it may lower.
template <typename Visit>
HWY_INLINE void visit_leaves(const std::vector<TriangleBvhNode>& nodes, const std::vector<TriangleBvhLeaf>& leaves,
                             const Eigen::Vector3d& x, float squared_limit, const Visit& visit) {
  const Eigen::Vector3f x_single = x.cast<float>();
  std::array<Waiting, stack_size> stack;
  int top = push_children(nodes.front(), x_single, squared_limit, stack, 0);
  while (top > 0) {
    const Waiting next = stack[static_cast<std::size_t>(--top)];
    if (!(next.squared_distance < squared_limit)) continue;
    if (next.child >= 0) {
      top = push_children(nodes[static_cast<std::size_t>(next.child)], x_single, squared_limit, stack, top);
    } else {
      const std::int32_t leaf = ~next.child;
      visit(leaves[static_cast<std::size_t>(leaf)], squared_limit);
    }
  }
}

std::int32_t closest(const std::vector<TriangleBvhNode>& nodes, const std::vector<TriangleBvhLeaf>& leaves,
                     const Eigen::Vector3d& x, float squared_limit, std::int32_t otherwise) {
  std::int32_t best = otherwise;
  visit_leaves(nodes, leaves, x, squared_limit, [&](const TriangleBvhLeaf& leaf, float& limit) {
    const std::int32_t found = closest_in_leaf(leaf, x, limit);
    if (found >= 0) best = found;
  });
  return best;
}

/// Computes the squared distances from the apex to the children that may meet ball and cone, infinity for the others.
/// The compiler vectorises the loops.
void in_reach(const TriangleBvhNode& node, const BallAndCone& query,
              std::array<float, children_per_node>& squared_distances) {
  using Lanes = std::array<float, children_per_node>;
  alignas(64) Lanes to_ball2{};
  alignas(64) Lanes to_apex2{};
  alignas(64) Lanes height{};  // of the disk above the ball's centre
  alignas(64) Lanes along{};   // the axis, from the apex to the middle of the disk
  alignas(64) Lanes from_apex2{};
  alignas(64) Lanes normal_cosine{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float centre = query.centre[static_cast<Eigen::Index>(k)];
    const float apex = query.apex[static_cast<Eigen::Index>(k)];
    const float axis = query.axis[static_cast<Eigen::Index>(k)];
    for (std::size_t i = 0; i < children_per_node; ++i) {
      const float ball_gap = std::max(std::max(node.low[k][i] - centre, centre - node.high[k][i]), 0.0F);
      const float apex_gap = std::max(std::max(node.low[k][i] - apex, apex - node.high[k][i]), 0.0F);
      const float from_apex = node.centre[k][i] - apex;
      to_ball2[i] += ball_gap * ball_gap;
      to_apex2[i] += apex_gap * apex_gap;
      height[i] += (node.centre[k][i] - centre) * node.normal[k][i];
      along[i] += from_apex * axis;
      normal_cosine[i] += node.normal[k][i] * axis;
      from_apex2[i] += from_apex * from_apex;
    }
  }
  constexpr float rounding = 1e-6F;
  // NOLINTBEGIN(readability-implicit-bool-conversion): & instead of &&, for a loop of vectors
  for (std::size_t i = 0; i < children_per_node; ++i) {
    const float reach = along[i] * query.sine + node.half_height[i] + node.radius[i] + rounding;
    const float off_axis2 = from_apex2[i] - along[i] * along[i];
    const bool in_cone = (reach >= 0) & (off_axis2 * query.squared_cosine <= reach * reach);
    const bool in_slab = std::abs(height[i]) - node.half_height[i] <= query.radius;
    const bool in_ball = to_ball2[i] <= query.radius * query.radius;
    const bool faces_axis = std::abs(normal_cosine[i]) + node.normal_deviation[i] >= query.min_normal_cosine;
    const bool is_candidate = in_cone & in_slab & in_ball & faces_axis;
    squared_distances[i] = is_candidate ? to_apex2[i] : std::numeric_limits<float>::infinity();
  }
  // NOLINTEND(readability-implicit-bool-conversion)
}

/// The loops over the triangles are vectorised by the compiler.
std::uint32_t facing(const TriangleBvhLeaf& leaf, const Cone& cone) {
  const Eigen::Vector3f apex = (cone.apex - leaf.origin).cast<float>();
  const Eigen::Vector3f axis = cone.axis.cast<float>();
  alignas(64) LeafLane height{};  // of the plane above the apex
  alignas(64) LeafLane cosine{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < triangles_per_leaf; ++i) {
      height[i] += (leaf.a[k][i] - apex[static_cast<Eigen::Index>(k)]) * leaf.normal[k][i];
      cosine[i] += axis[static_cast<Eigen::Index>(k)] * leaf.normal[k][i];
    }
  }
  constexpr float rounding = 1e-6F;
  const float limit = static_cast<float>(cone.min_normal_cosine) - rounding;
  std::uint32_t lanes = 0;
  for (std::size_t i = 0; i < triangles_per_leaf; ++i) {
    const bool faces_away = !cone.faces_away || std::abs(height[i]) <= rounding || (height[i] > 0) == (cosine[i] > 0);
    const float size = std::abs(cosine[i]);
    lanes |= static_cast<std::uint32_t>((faces_away ? size : -size) >= limit) << i;
  }
  return lanes & ((1U << static_cast<unsigned>(leaf.used_slots)) - 1);
}

void distances_to(const TriangleBvhLeaf& leaf, const Eigen::Vector3d& x, LeafLane& result) {
  squared_distances(leaf, x, result);
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(closest);
HWY_EXPORT(distances_to);
HWY_EXPORT(facing);
HWY_EXPORT(in_reach);

std::int32_t closest_triangle(const std::vector<TriangleBvhNode>& nodes, const std::vector<TriangleBvhLeaf>& leaves,
                              const Eigen::Vector3d& x, float squared_limit, std::int32_t otherwise) {
  return HWY_DYNAMIC_DISPATCH(closest)(nodes, leaves, x, squared_limit, otherwise);
}

void child_distances_in_reach(const TriangleBvhNode& node, const BallAndCone& query,
                              std::array<float, children_per_node>& squared_distances) {
  HWY_DYNAMIC_DISPATCH(in_reach)(node, query, squared_distances);
}

std::uint32_t triangles_facing(const TriangleBvhLeaf& leaf, const Cone& cone) {
  return HWY_DYNAMIC_DISPATCH(facing)(leaf, cone);
}

void squared_distances_to_triangles(const TriangleBvhLeaf& leaf, const Eigen::Vector3d& x, LeafLane& result) {
  HWY_DYNAMIC_DISPATCH(distances_to)(leaf, x, result);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
