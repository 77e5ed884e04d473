#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shapegauge/core/spatial/closest_point.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

inline constexpr int children_per_node = 8;
inline constexpr int triangles_per_leaf = 16;

/// The boxes of eight children, coordinate by coordinate, and for each a disk: a flat cylinder about the mean normal of
/// its triangles. On a smooth surface it is much thinner than the box, the more so the finer the triangles. Unused
/// places hold an empty box, infinitely far from anything.
struct alignas(64) TriangleBvhNode {
  std::array<std::array<float, children_per_node>, 3> low;
  std::array<std::array<float, children_per_node>, 3> high;
  std::array<std::array<float, children_per_node>, 3> centre;  ///< of the disk
  std::array<std::array<float, children_per_node>, 3> normal;  ///< zero where there is none; then the disk is a ball
  std::array<float, children_per_node> half_height;
  std::array<float, children_per_node> radius;
  std::array<std::int32_t, children_per_node> child;  ///< a node's index, or ~index of a leaf
};

/// A number for each of a leaf's triangles.
using LeafLane = std::array<float, triangles_per_leaf>;
/// A vector for each of a leaf's triangles.
using LeafVector = std::array<LeafLane, 3>;

/// Sixteen triangles relative to an origin near them, so that single precision is relative to their size and not to the
/// whole shape's. Unused places repeat a used one.
struct alignas(64) TriangleBvhLeaf {
  LeafVector a;   ///< first corner
  LeafVector ab;  ///< edges from the first corner
  LeafVector ac;
  LeafVector normal;  ///< unit normal
  LeafVector dual_b;  ///< dot(x - a, dual_b) is the barycentric coordinate of b; NaN for a degenerate triangle, so that
  LeafVector dual_c;  ///< no point projects into it
  LeafLane inverse_ab;  ///< 1 / squared length of the edge; 0 for an edge of no length
  LeafLane inverse_ac;
  LeafLane inverse_bc;
  std::array<std::int32_t, triangles_per_leaf> triangle;
  Eigen::Vector3d origin;
};

/// What the tree is made of. The root is node 0.
struct TriangleBVH::Layout {
  std::vector<Triangle> triangles;
  std::vector<TriangleBvhNode> nodes;
  std::vector<TriangleBvhLeaf> leaves;
};

/// Arranges the triangles into nodes and leaves by the surface area heuristic (binned, top down).
void build_triangle_bvh(std::vector<TriangleBvhNode>& nodes, std::vector<TriangleBvhLeaf>& leaves,
                        const std::vector<Triangle>& triangles);

/// The triangle of smallest squared distance to x below the limit, or `otherwise`.
std::int32_t closest_triangle(const std::vector<TriangleBvhNode>& nodes, const std::vector<TriangleBvhLeaf>& leaves,
                              const Eigen::Vector3d& x, float squared_limit, std::int32_t otherwise);

}  // namespace shapegauge
