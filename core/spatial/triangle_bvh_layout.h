// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shapegauge/core/spatial/closest_point.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

inline constexpr int children_per_node = 8;    ///< number of children of a node of a TriangleBVH
inline constexpr int triangles_per_leaf = 16;  ///< maximum number of triangles in a leaf of a TriangleBVH

/// Node of the tree: bounds of its eight children, as one array per coordinate. Each child has a box and a disk, which
/// is a flat cylinder about the mean normal of the child's triangles, turned to one side. On a smooth surface the disk
/// is much thinner than the box, the more so the finer the triangles. Unused slots hold an empty box at infinity.
struct alignas(64) TriangleBvhNode {
  std::array<std::array<float, children_per_node>, 3> low;     ///< minimum corner of each child's box
  std::array<std::array<float, children_per_node>, 3> high;    ///< maximum corner of each child's box
  std::array<std::array<float, children_per_node>, 3> centre;  ///< centre of each child's disk
  /// Unit axis of each child's disk; zero: the disk is a ball.
  std::array<std::array<float, children_per_node>, 3> normal;
  std::array<float, children_per_node> half_height;  ///< half of the height of each child's disk
  std::array<float, children_per_node> radius;       ///< radius of each child's disk
  /// Maximum length of the difference between the disk's normal and the unit normal of a triangle in the child, turned
  /// to the same side.
  std::array<float, children_per_node> normal_deviation;
  std::array<std::int32_t, children_per_node> child;  ///< index of the child node, or ~index of the child leaf
};

/// One float per triangle of a leaf.
using LeafLane = std::array<float, triangles_per_leaf>;
/// One three-dimensional vector per triangle of a leaf, as an array per coordinate.
using LeafVector = std::array<LeafLane, 3>;

/// Leaf of the tree: sixteen triangles relative to a nearby origin, which makes single precision relative to their size
/// and not to the whole shape. Unused slots repeat the last used one.
struct alignas(64) TriangleBvhLeaf {
  LeafVector a;         ///< first corner of each triangle, relative to `origin`
  LeafVector ab;        ///< edge of each triangle from the first to the second corner
  LeafVector ac;        ///< edge of each triangle from the first to the third corner
  LeafVector normal;    ///< unit normal of each triangle; zero if it is degenerate
  LeafVector dual_b;    ///< dot(x - a, dual_b) is the barycentric coordinate of x for b; NaN for a degenerate triangle
  LeafVector dual_c;    ///< dot(x - a, dual_c) is the barycentric coordinate of x for c; NaN for a degenerate triangle
  LeafLane inverse_ab;  ///< 1 / |ab|^2; 0 if the edge ab is degenerate
  LeafLane inverse_ac;  ///< 1 / |ac|^2; 0 if the edge ac is degenerate
  LeafLane inverse_bc;  ///< 1 / |bc|^2; 0 if the edge bc is degenerate
  std::array<std::int32_t, triangles_per_leaf> triangle;  ///< index of each triangle in the shape
  Eigen::Vector3d origin;                                 ///< centre of the triangles' bounding box
  std::int32_t used_slots;                                ///< number of triangles in the leaf
};

/// Arrays of a TriangleBVH, which refer to each other by indices. The root is node 0; without triangles there is none.
struct TriangleBVH::Layout {
  std::vector<Triangle> triangles;      ///< corners of each triangle, in the order of the shape
  std::vector<TriangleBvhNode> nodes;   ///< inner nodes of the tree; the root is node 0
  std::vector<TriangleBvhLeaf> leaves;  ///< leaves of the tree, with up to sixteen triangles each
};

/// Ball and cone of TriangleBVH::search(), in single precision.
struct BallAndCone {
  Eigen::Vector3f centre;  ///< centre of the ball
  float radius;            ///< radius of the ball, enlarged by the rounding error
  Eigen::Vector3f apex;    ///< apex of the cone
  Eigen::Vector3f axis;    ///< unit axis of the cone
  float squared_cosine;    ///< squared cosine of the angle between the cone's axis and boundary
  float sine;              ///< sine of the angle between the cone's axis and boundary
  /// Minimum cosine between the axis and a triangle's normal (Cone), minus the rounding error.
  float min_normal_cosine;
};

/// Computes, for each child of a node, the squared distance from the cone's apex to the child's box. It is infinite if
/// the child cannot intersect ball and cone, or if its normals deviate too much from the axis. Rounds in the same way
/// on every processor.
void child_distances_in_reach(const TriangleBvhNode& node, const BallAndCone& query,
                              std::array<float, children_per_node>& squared_distances);

/// Builds the nodes and leaves of a tree over at least one triangle, top down by the binned surface area heuristic.
void build_triangle_bvh(std::vector<TriangleBvhNode>& nodes, std::vector<TriangleBvhLeaf>& leaves,
                        const std::vector<Triangle>& triangles);

/// Returns the index of the triangle closest to x if its squared distance is below `squared_limit`; otherwise returns
/// `otherwise`. `nodes` and `leaves` are those of build_triangle_bvh().
std::int32_t closest_triangle(const std::vector<TriangleBvhNode>& nodes, const std::vector<TriangleBvhLeaf>& leaves,
                              const Eigen::Vector3d& x, float squared_limit, std::int32_t otherwise);

/// Returns a bit mask of the leaf's triangles (bit i: slot i) whose normals satisfy min_normal_cosine and faces_away of
/// the cone.
std::uint32_t triangles_facing(const TriangleBvhLeaf& leaf, const Cone& cone);

/// Computes the squared distances from x to the leaf's triangles, one per slot, in single precision.
void squared_distances_to_triangles(const TriangleBvhLeaf& leaf, const Eigen::Vector3d& x, LeafLane& result);

}  // namespace shapegauge
