#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace shapegauge {

/// All points x with dot(normal, x) >= bound. The normal has length 1.
struct HalfSpace {
  Eigen::Vector3d normal;
  double bound;
};

/// The point closest to p that lies in all of the half-spaces, or nothing where they have no common point (or only
/// points so far away that the answer would be meaningless). Meant for a handful of half-spaces.
std::optional<Eigen::Vector3d> closest_point_in(std::span<const HalfSpace> half_spaces, const Eigen::Vector3d& p);

}  // namespace shapegauge
