#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vector>

#include "tests/core/spatial/random_triangle.h"
#include "tests/oracle/half_spaces.h"

namespace shapegauge {
namespace {

/// Half-spaces that all hold the point `inside`.
std::vector<HalfSpace> half_spaces_around(const Eigen::Vector3d& inside) {
  std::vector<HalfSpace> result;
  const int count = *rc::gen::inRange(0, 7);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d direction = random_point() + Eigen::Vector3d(0, 0, 1e-3);
    if (direction.norm() < 1e-2) continue;
    const Eigen::Vector3d normal = direction.normalized();
    result.push_back({normal, normal.dot(inside) - *rc::gen::inRange(0, 500) / 1000.0});
  }
  return result;
}

/// Dykstra's alternating projections: slow, and an independent way to the same point.
Eigen::Vector3d projected_by_dykstra(const std::vector<HalfSpace>& half_spaces, const Eigen::Vector3d& p) {
  Eigen::Vector3d x = p;
  std::vector<Eigen::Vector3d> corrections(half_spaces.size(), Eigen::Vector3d::Zero());
  for (int round = 0; round < 20000; ++round) {
    for (std::size_t i = 0; i < half_spaces.size(); ++i) {
      const Eigen::Vector3d y = x + corrections[i];
      const double missing = half_spaces[i].bound - half_spaces[i].normal.dot(y);
      x = y + std::max(missing, 0.0) * half_spaces[i].normal;
      corrections[i] = y - x;
    }
  }
  return x;
}

RC_GTEST_PROP(HalfSpaces, GiveThePointThatAlternatingProjectionsFind, ()) {
  const std::vector<HalfSpace> half_spaces = half_spaces_around(random_point());
  const Eigen::Vector3d p = 2 * random_point();
  const auto found = closest_point_in(half_spaces, p);
  RC_ASSERT(found.has_value());
  for (const HalfSpace& half_space : half_spaces) RC_ASSERT(half_space.normal.dot(*found) >= half_space.bound - 1e-7);
  // Never farther than the other way's point; that one converges slowly where planes are nearly parallel.
  RC_ASSERT((*found - p).norm() <= (projected_by_dykstra(half_spaces, p) - p).norm() + 1e-3);
}

TEST(HalfSpaces, ThatExcludeEachOtherHaveNoPoint) {
  const std::vector<HalfSpace> half_spaces = {{{0, 0, 1}, 1}, {{0, 0, -1}, 1}};
  EXPECT_FALSE(closest_point_in(half_spaces, {0, 0, 0}).has_value());
}

TEST(HalfSpaces, GiveTheCornerOfThreePlanes) {
  const std::vector<HalfSpace> half_spaces = {{{1, 0, 0}, 1}, {{0, 1, 0}, 2}, {{0, 0, 1}, 3}};
  EXPECT_TRUE(closest_point_in(half_spaces, {0, 0, 0})->isApprox(Eigen::Vector3d(1, 2, 3)));
}

}  // namespace
}  // namespace shapegauge
