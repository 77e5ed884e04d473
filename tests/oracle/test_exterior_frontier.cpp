#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <vector>

#include "tests/core/spatial/random_triangle.h"
#include "tests/oracle/exterior_frontier.h"

namespace shapegauge {
namespace {

struct Cube {
  Eigen::Vector3d centre;
  double half;
  std::vector<HalfSpace> bounds;  ///< none or two
  bool removed = false;
};

Cube random_cube() {
  Cube cube{2 * random_point(), *rc::gen::inRange(1, 50) / 100.0, {}};
  if (*rc::gen::inRange(0, 3) == 0) return cube;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d normal = (random_point() + Eigen::Vector3d(0, 0, 1e-3)).normalized();
    cube.bounds.push_back({normal, *rc::gen::inRange(-100, 100) / 100.0});
  }
  return cube;
}

/// The distance to the cube, or that to the intersection of its half-spaces, whichever is larger; infinite where there
/// is none, as then the cube is empty.
double lower_bound(const Cube& cube, const Eigen::Vector3d& p) {
  const double to_cube = ((p - cube.centre).cwiseAbs().array() - cube.half).cwiseMax(0).matrix().norm();
  const auto nearest = closest_point_in(cube.bounds, p);
  return nearest ? std::max(to_cube, (*nearest - p).norm()) : std::numeric_limits<double>::infinity();
}

RC_GTEST_PROP(ExteriorFrontier, MissesNoCubeBelowTheLimitAndBoundsSoundly, ()) {
  const Eigen::Vector3d origin = random_point();
  ExteriorFrontier frontier;
  frontier.restart(random_point());
  frontier.add(random_point(), 1);  // forgotten
  frontier.restart(origin);
  std::vector<Cube> cubes;
  const int count = *rc::gen::inRange(0, 60);
  for (int i = 0; i < count; ++i) {
    cubes.push_back(random_cube());
    frontier.add(cubes.back().centre, cubes.back().half);
    if (!cubes.back().bounds.empty()) frontier.bound(i, cubes.back().bounds[0], cubes.back().bounds[1]);
  }
  for (int i = 0; i < count; i += 7) {
    frontier.remove(i);
    cubes[static_cast<std::size_t>(i)].removed = true;
  }
  const Eigen::Vector3d p = 2 * random_point();
  const double limit = *rc::gen::inRange(0, 300) / 100.0;
  const int first = *rc::gen::inRange(0, count + 1);
  std::vector<NearbyCube> found;
  frontier.find_nearer(p, limit, first, found);
  std::vector<bool> is_found(cubes.size());
  for (const NearbyCube& nearby : found) {
    RC_ASSERT(nearby.cube >= first);
    RC_ASSERT(!is_found[static_cast<std::size_t>(nearby.cube)]);
    is_found[static_cast<std::size_t>(nearby.cube)] = true;
    const Cube& cube = cubes[static_cast<std::size_t>(nearby.cube)];
    RC_ASSERT(!cube.removed);
    RC_ASSERT(static_cast<double>(nearby.lower_bound) < lower_bound(cube, p) + 1e-4);
    RC_ASSERT(static_cast<double>(nearby.lower_bound) < limit);
  }
  for (int i = 0; i < count; ++i) {
    const Cube& cube = cubes[static_cast<std::size_t>(i)];
    const bool expected = i >= first && !cube.removed && lower_bound(cube, p) < limit;
    const bool in_doubt = std::abs(lower_bound(cube, p) - limit) < 1e-4;  // single precision
    RC_ASSERT(!expected || in_doubt || is_found[static_cast<std::size_t>(i)]);
  }
}

TEST(ExteriorFrontier, BoundsByTheLineWhereTwoHalfSpacesMeet) {
  ExteriorFrontier frontier;
  frontier.restart(Eigen::Vector3d::Zero());
  frontier.add(Eigen::Vector3d(1, 1, 0), 2);
  frontier.bound(0, {{1, 0, 0}, 3}, {{0, 1, 0}, 4});
  std::vector<NearbyCube> found;
  frontier.find_nearer(Eigen::Vector3d::Zero(), 5.01, 0, found);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FLOAT_EQ(found[0].lower_bound, 5);
  found.clear();
  frontier.find_nearer(Eigen::Vector3d::Zero(), 4.99, 0, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace shapegauge
