#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

/// How a ray crosses the surface.
struct RayParity {
  int count = 0;
  int balance = 0;  ///< crossings along the triangles' normals minus those against them
};

/// The queries that the proven search asks of a surface, made of the one that the library has.
class SurfaceTree {
 public:
  explicit SurfaceTree(const Shape& shape);

  [[nodiscard]] std::optional<ClosestHit> closest(const Eigen::Vector3d& x,
                                                  double max_distance = std::numeric_limits<double>::infinity(),
                                                  std::int32_t hint = -1) const {
    return tree_.closest(x, max_distance, hint);
  }

  /// A triangle and its distance from a point, in single precision.
  struct Nearest {
    std::int32_t triangle = -1;  ///< -1: none is near enough
    float distance = std::numeric_limits<float>::infinity();
  };
  static constexpr std::size_t most_points_at_once = 8;

  /// The closest triangle to each of a few points, among those nearer than max_distance.
  [[nodiscard]] std::array<Nearest, most_points_at_once> closest_to_each(std::span<const Eigen::Vector3d> points,
                                                                         double max_distance) const;

  /// Some triangle nearer than the distance, or nothing.
  [[nodiscard]] std::optional<std::int32_t> any_within(const Eigen::Vector3d& x, double distance) const;

  /// The crossings of the ray from x with the surface, or nothing where one is too close to an edge to be sure: tries
  /// all triangles.
  [[nodiscard]] std::optional<RayParity> ray_parity(const Eigen::Vector3d& x, const Eigen::Vector3d& direction) const;

  [[nodiscard]] const Triangle& triangle(std::int32_t index) const {
    return triangles_[static_cast<std::size_t>(index)];
  }

 private:
  TriangleBVH tree_;
  std::vector<Triangle> triangles_;
};

}  // namespace shapegauge
