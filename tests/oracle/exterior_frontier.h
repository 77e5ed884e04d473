#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "tests/oracle/half_spaces.h"

namespace shapegauge {

/// A cube of the frontier, and a lower bound of its exterior points' distance from the point that was asked about.
struct NearbyCube {
  float lower_bound;
  std::int32_t cube;
};

/// Cubes of space that may hold exterior points, each with two half-spaces that all of its exterior points lie in, in a
/// layout that lets a search look at many at once. Lower bounds are in single precision relative to the origin.
class ExteriorFrontier {
 public:
  /// Forgets all cubes. Those to come are near the origin.
  void restart(const Eigen::Vector3d& origin);

  /// Adds a cube; nothing is known of its exterior points. Cubes are numbered from 0 on.
  void add(const Eigen::Vector3d& centre, double half);

  /// Says in which half-spaces (twice the same for one) the exterior points of a cube lie, instead of what was said
  /// before.
  void bound(std::int32_t cube, const HalfSpace& first, const HalfSpace& second);

  /// The cube is looked at no more.
  void remove(std::int32_t cube);

  [[nodiscard]] std::int32_t size() const { return size_; }

  /// Appends the cubes from `first` on whose lower bound for p is below the limit.
  void find_nearer(const Eigen::Vector3d& p, double limit, std::int32_t first, std::vector<NearbyCube>& found) const;

 private:
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::int32_t size_ = 0;
  // Padded with cubes that are infinitely far away.
  std::vector<float> x_, y_, z_, half_;
  /// Of the half-spaces; cosine_ is that of the angle between the two.
  std::array<std::vector<float>, 2> normal_x_, normal_y_, normal_z_, bound_;
  std::vector<float> cosine_;
};

}  // namespace shapegauge
