#pragma once

#include <Eigen/Core>
#include <array>

#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// Four neighbouring patches of a sphere, the quarters of a square on the circumscribed cube's face seen from the
/// centre: their four middles and the nine points at which their corners meet, relative to the sphere's centre.
struct PatchQuad {
  static constexpr int lanes = 16;  ///< 13 points, padded for SIMD with the last one
  alignas(64) std::array<float, lanes> x, y, z;

  /// Lane of the middle of a quarter (bit 0: upper half along u, bit 1: along v).
  static constexpr std::array<int, 4> middle_lane = {9, 10, 11, 12};
  /// Lanes of the corners of each quarter.
  static constexpr std::array<std::array<int, 4>, 4> corner_lanes = {
      {{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 4, 6, 7}, {4, 5, 7, 8}}};

  [[nodiscard]] Eigen::Vector3d point(int lane) const {
    const auto i = static_cast<std::size_t>(lane);
    return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
  }
};

/// The quad on a sphere about the origin. The face is 0 to 5: axis face % 3, on the negative side from 3 on; (u, v) is
/// the square's middle in the face, whose sides are at -1 and 1, and half is half of its edge.
PatchQuad patch_quad(double radius, int face, double u, double v, double half);

/// Squared distances from the quad's points to the triangle, whose corners are relative to the sphere's centre too,
/// with an error of about 1e-6 of the radius' square.
std::array<float, PatchQuad::lanes> squared_distances(const PatchQuad& quad, const Triangle& triangle);

}  // namespace shapegauge
