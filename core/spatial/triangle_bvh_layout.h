// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shapegauge/core/spatial/closest_point.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

inline constexpr int children_per_node = 8;
inline constexpr int triangles_per_leaf = 16;

/// Bounds of eight children, coordinate by coordinate: a box and a disk, which is a flat cylinder about the mean normal
/// of the child's triangles, turned to one side. On a smooth surface the disk is much thinner than the box, the more so
/// the finer the triangles. Unused slots hold an empty box at infinity.
struct alignas(64) TriangleBvhNode {
  std::array<std::array<float, children_per_node>, 3> low;
  std::array<std::array<float, children_per_node>, 3> high;
  std::array<std::array<float, children_per_node>, 3> centre;  ///< of the disk
  std::array<std::array<float, children_per_node>, 3> normal;  ///< zero if undefined; the disk is then a ball
  std::array<float, children_per_node> half_height;
  std::array<float, children_per_node> radius;
  /// Maximum length of the difference between a triangle's unit normal, turned to the same side, and that of the disk.
  std::array<float, children_per_node> normal_deviation;
  std::array<std::int32_t, children_per_node> child;  ///< index of a node, or ~index of a leaf
};

/// Scalar for each triangle of a leaf.
using LeafLane = std::array<float, triangles_per_leaf>;
/// Vector for each triangle of a leaf.
using LeafVector = std::array<LeafLane, 3>;

/// Sixteen triangles relative to a nearby origin, which makes single precision relative to their size and not to the
/// whole shape. Unused slots repeat the last used one.
struct alignas(64) TriangleBvhLeaf {
  LeafVector a;   ///< first corner
  LeafVector ab;  ///< edges from the first corner
  LeafVector ac;
  LeafVector normal;  ///< unit normal
  LeafVector dual_b;  ///< dot(x - a, dual_b) is the barycentric coordinate of b; NaN for a degenerate triangle, so that
  LeafVector dual_c;  ///< no point projects into it
  LeafLane inverse_ab;  ///< 1 / squared length of the edge; 0 for a degenerate edge
  LeafLane inverse_ac;
  LeafLane inverse_bc;
  std::array<std::int32_t, triangles_per_leaf> triangle;
  Eigen::Vector3d origin;
  std::int32_t used_slots;
};

/// Data of the tree. The root is node 0.
struct TriangleBVH::Layout {
  std::vector<Triangle> triangles;
  std::vector<TriangleBvhNode> nodes;
  std::vector<TriangleBvhLeaf> leaves;
};

/// Ball and cone of a search, in single precision.
struct BallAndCone {
  Eigen::Vector3f centre;
  float radius;
  Eigen::Vector3f apex;
  Eigen::Vector3f axis;
  float squared_cosine;
  float sine;
  float min_normal_cosine;
};

/// Computes the squared distances from the apex to the boxes of the children that may intersect ball and cone and face
/// the axis; infinity for others. Rounds in the same way on every processor.
void distances_in_reach(const TriangleBvhNode& node, const BallAndCone& query,
                        std::array<float, children_per_node>& squared_distances);

/// Builds nodes and leaves top down by the binned surface area heuristic.
void build_triangle_bvh(std::vector<TriangleBvhNode>& nodes, std::vector<TriangleBvhLeaf>& leaves,
                        const std::vector<Triangle>& triangles);

/// Returns the triangle with the smallest squared distance to x below the limit, or `otherwise`.
std::int32_t closest_triangle(const std::vector<TriangleBvhNode>& nodes, const std::vector<TriangleBvhLeaf>& leaves,
                              const Eigen::Vector3d& x, float squared_limit, std::int32_t otherwise);

/// Returns a bit mask of the leaf's triangles whose normals are within the cone's limit.
std::uint32_t triangles_facing(const TriangleBvhLeaf& leaf, const Cone& cone);

/// Computes the squared distances from x to the leaf's triangles.
void squared_distances_to_triangles(const TriangleBvhLeaf& leaf, const Eigen::Vector3d& x, LeafLane& result);

}  // namespace shapegauge
