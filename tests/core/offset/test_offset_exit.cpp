// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/offset_exit.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/spatial/closest_point.h"
#include "tests/core/sdf/crevice_shapes.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Distances along rays to the exterior of a shape, in the shape's units.
class ExitOf {
 public:
  ExitOf(const Shape& shape, double offset, double cells_per_offset = 3)
      : grid_(bounding_box(shape), offset, offset / cells_per_offset),
        surface_(grid_, shape, 0.75, false),
        exterior_(grid_, surface_, 0.9, false) {}

  double operator()(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    std::vector<OffsetExitTask> tasks{task(origin, direction)};
    solve(tasks);
    return tasks[0].exit * grid_.cell;
  }

  void solve(std::vector<OffsetExitTask>& tasks) const {
    ClosestTriangles closest(grid_, surface_);
    find_offset_exits(exterior_, closest, tasks);
  }
  [[nodiscard]] OffsetExitTask task(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    return {.origin = grid_.to_cells(origin), .direction = direction};
  }
  [[nodiscard]] const ExteriorGrid& exterior() const { return exterior_; }

 private:
  BlockGrid grid_;
  GridSurface surface_;
  ExteriorGrid exterior_;
};

Eigen::Vector3d random_direction(RandomNumbers& random) {
  for (;;) {
    const Eigen::Vector3d v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

/// Parameter at which a ray leaves a ball about the origin that contains its origin.
double exit_of_ball(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double radius) {
  const double along = origin.dot(direction);
  return -along + std::sqrt(along * along + radius * radius - origin.squaredNorm());
}

TEST(OffsetExit, OfASphereIsOnItsOffsetSphere) {
  const double r = 0.2;
  const Shape sphere = test::sphere(1, 5);
  const ExitOf exit(sphere, r);
  RandomNumbers random(1);
  const Samples samples = sample_shape(sphere, SampleSite::faces);
  for (Eigen::Index i = 0; i < samples.points.rows(); i += 31) {
    const Eigen::Vector3d p = samples.points.row(i);
    const Eigen::Vector3d direction = random_direction(random);  // outwards and inwards, through the sphere
    const double t = exit(p, direction);
    EXPECT_NEAR((p + t * direction).norm(), 1 + r, 0.01 * r) << p.transpose() << " along " << direction.transpose();
    // The same along the ray; it is oblique for tangents.
    const double cosine = direction.dot((p + t * direction).normalized());
    EXPECT_NEAR(t, exit_of_ball(p, direction, 1 + r), 0.01 * r / cosine);
  }
}

TEST(OffsetExit, MatchesTheExactExitAlongAxesAndDiagonals) {
  // Directions with zeros; from all sides of a cube, whose exits are known.
  const double r = 0.2;
  const ExitOf exit(test::box({2, 2, 2}, 4), r);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d out = side * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d p =
          out + Eigen::Vector3d(0.123, -0.217, 0.071).cwiseProduct(Eigen::Vector3d::Ones() - out.cwiseAbs());
      EXPECT_NEAR(exit(p, out), r, 0.002 * r);
      EXPECT_NEAR(exit(p, -out), 2 + r, 0.002 * r);
      const Eigen::Vector3d across = Eigen::Vector3d::Unit((axis + 1) % 3);
      EXPECT_NEAR(exit(p, (out + across).normalized()), std::sqrt(2) * r, 0.003 * r);
      EXPECT_NEAR(exit(p, across), 1 + r - p[(axis + 1) % 3], 0.003 * r) << "along the side";
    }
  }
}

/// Distance from x to the nearest of a mesh's triangles, by exhaustive search.
double distance_to_mesh(const Shape& mesh, const Eigen::Vector3d& x) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& row : mesh.triangles.rowwise()) {
    const Triangle triangle{mesh.vertices.row(row[0]), mesh.vertices.row(row[1]), mesh.vertices.row(row[2])};
    nearest = std::min(nearest, (closest_point(triangle, x) - x).norm());
  }
  return nearest;
}

TEST(OffsetExit, OfAConvexShapeIsThePointAtTheOffsetDistance) {
  const double r = 0.15;
  const Shape box = test::transformed(test::box({1, 0.7, 0.4}, 2), 1, test::rotation(3), {5, -2, 1});
  const ExitOf exit(box, r);
  const Samples samples = sample_shape(box, SampleSite::faces);
  RandomNumbers random(2);
  for (int round = 0; round < 300; ++round) {
    const auto i = static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(samples.points.rows())));
    const Eigen::Vector3d p = samples.points.row(i);
    const Eigen::Vector3d direction = random_direction(random);
    // The offset solid is convex, and the ray leaves it once: bisection.
    double low = 0;
    double high = 2;
    const auto is_outside = [&](double t) {
      const Eigen::Vector3d local = test::rotation(3).transpose() * (p + t * direction - Eigen::Vector3d(5, -2, 1));
      const bool inside = (local.array().abs() < Eigen::Array3d(0.5, 0.35, 0.2)).all();
      return !inside && distance_to_mesh(box, p + t * direction) > r;
    };
    ASSERT_TRUE(is_outside(high));
    for (int step = 0; step < 40; ++step) {
      const double middle = (low + high) / 2;
      (is_outside(middle) ? high : low) = middle;
    }
    const double t = exit(p, direction);
    EXPECT_NEAR(distance_to_mesh(box, p + t * direction), r, 0.002 * r);
    // The ray is at most 2 long and crosses the offset surface at a sine of at least r / 2.
    EXPECT_NEAR(t, high, 0.002 * 2) << p.transpose() << " along " << direction.transpose();
  }
}

TEST(OffsetExit, OfATorusIsTheFirstPointOutsideItsOffset) {
  const double ring = 1;
  const double tube = 0.4;
  const double r = 0.1;
  const Shape torus = test::torus(ring, tube, 160, 80);
  const ExitOf exit(torus, r, 4);
  const auto signed_distance = [&](const Eigen::Vector3d& x) {
    return std::hypot(std::hypot(x.x(), x.y()) - ring, x.z()) - tube;
  };
  const Samples samples = sample_shape(torus, SampleSite::faces);
  RandomNumbers random(3);
  int through_the_hole = 0;
  for (Eigen::Index i = 0; i < samples.points.rows(); i += 61) {
    const Eigen::Vector3d p = samples.points.row(i);
    const Eigen::Vector3d direction = random_direction(random);
    const double t = exit(p, direction);
    const Eigen::Vector3d q = p + t * direction;
    EXPECT_NEAR(signed_distance(q), r, 0.02 * r) << p.transpose() << " along " << direction.transpose();
    const double step = 0.05 * r;
    for (int k = 0; k * step < t; ++k) EXPECT_LT(signed_distance(p + k * step * direction), 1.02 * r) << k * step / t;
    through_the_hole += std::hypot(q.x(), q.y()) < ring - tube ? 1 : 0;
  }
  EXPECT_GT(through_the_hole, 10);
}

TEST(OffsetExit, LiesBeyondVoidsAndNarrowGaps) {
  const double r = 0.1;
  const Shape hollow = test::joined({test::sphere(1, 5), test::flipped(test::sphere(0.6, 5))});
  const ExitOf exit_of_hollow(hollow, r);
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 2, -1).normalized();
  EXPECT_NEAR(exit_of_hollow(-0.6 * direction, direction), 0.6 + 1 + r, 0.01 * r) << "a void is not exterior";

  for (const double gap : {1.5 * r, 3 * r}) {
    // The lower plate from -0.2 to 0, the upper one from gap to gap + 0.2.
    const auto plate = [](double low) {
      return test::transformed(test::box({2, 2, 0.2}, 6), 1, Eigen::Matrix3d::Identity(), {0, 0, low + 0.1});
    };
    const ExitOf exit(test::joined({plate(-0.2), plate(gap)}), r);
    EXPECT_NEAR(exit({0.03, 0.05, 0}, {0, 0, 1}), gap < 2 * r ? gap + 0.2 + r : r, 0.005 * r) << gap;
    EXPECT_NEAR(exit({0.03, 0.05, 0}, {0, 0, -1}), 0.2 + r, 0.005 * r) << gap;
  }
}

TEST(OffsetExit, OfAPointCloudIsThePointAtWhichTheRayLeavesAllBalls) {
  const double r = 0.3;
  const Shape cloud{Points{{0, 0, 0}, {0.4, 0, 0}, {2, 0, 0}}, {}, {}};
  const ExitOf exit(cloud, r);
  EXPECT_NEAR(exit({0, 0, 0}, {1, 0, 0}), 0.4 + r, 0.005 * r);
  EXPECT_NEAR(exit({0, 0, 0}, {0, 1, 0}), r, 0.005 * r);
  EXPECT_NEAR(exit({2, 0, 0}, {-1, 0, 0}), r, 0.005 * r);
  const Eigen::Vector3d oblique = Eigen::Vector3d(1, 1, 0).normalized();
  // The ball about the second point covers the ray up to here.
  const double along = 0.4 * oblique.x();
  EXPECT_NEAR(exit({0, 0, 0}, oblique), along + std::sqrt(along * along + r * r - 0.16), 0.005 * r);
}

/// Returns true if a cell of the eight around x is exterior: the literal definition of the rays' cubes.
bool touches_exterior(const ExteriorGrid& exterior, const Eigen::Vector3d& x) {
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const Eigen::Vector3i cell = (x.array() - 0.5).floor().cast<int>() + step.array().cast<int>();
    if ((cell.array() < 0).any() || (cell.array() >= block_edge * exterior.grid().blocks.array()).any()) return true;
    const Eigen::Vector3i in_block = cell - block_edge * (cell / block_edge);
    const int bit = in_block.x() + block_edge * (in_block.y() + block_edge * in_block.z());
    if ((exterior.exterior_cells(exterior.grid().block_index(cell / block_edge)) >> bit & 1U) != 0) return true;
  }
  return false;
}

TEST(OffsetExit, IsTheFirstPointAtAnExteriorCellBeyondTheOffset) {
  const double r = 0.05;
  const Shape shape = test::of_diagonal_1(test::star());
  const ExitOf exit(shape, r);
  const BlockGrid& grid = exit.exterior().grid();
  const Samples samples = sample_shape(shape, SampleSite::faces);
  RandomNumbers random(5);
  int checked = 0;
  for (Eigen::Index i = 0; i < samples.points.rows(); i += 3) {
    const Eigen::Vector3d p = samples.points.row(i);
    const Eigen::Vector3d direction = random_direction(random);
    const double t = exit(p, direction);
    EXPECT_GT(distance_to_mesh(shape, p + t * direction), 0.98 * r) << i;
    // The walk may pass a corner of a cube by less than this.
    const double margin = 0.05 * r;
    const double step = 0.13 * r;
    for (int k = 0; r + k * step < t - margin; ++k) {
      const double s = r + k * step;
      const bool is_free = distance_to_mesh(shape, p + s * direction) > 1.02 * r;
      const bool is_at_exterior = touches_exterior(exit.exterior(), grid.to_cells(p + (s - margin) * direction)) &&
                                  touches_exterior(exit.exterior(), grid.to_cells(p + (s + margin) * direction));
      EXPECT_FALSE(is_free && is_at_exterior) << i << " at " << s / r << " of " << t / r;
      ++checked;
    }
  }
  EXPECT_GT(checked, 1000);
}

}  // namespace
}  // namespace shapegauge
