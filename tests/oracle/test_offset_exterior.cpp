#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/core/spatial/random_triangle.h"
#include "tests/oracle/offset_exterior.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Distance from x to the circle about z of the ring's radius.
double distance_to_ring(const Eigen::Vector3d& x, double ring) { return std::hypot(x.head<2>().norm() - ring, x.z()); }

RC_GTEST_PROP(OffsetExterior, TellsInsideFromOutsideOfATorusHoweverOriented, ()) {
  constexpr double ring = 0.35;
  constexpr double tube = 0.12;
  static const Shape torus = test::torus(ring, tube, 64, 32);
  static const Shape flipped = test::flipped(torus);
  const bool flip = *rc::gen::arbitrary<bool>();
  const bool closed = *rc::gen::arbitrary<bool>();  // without the help of parity the flood decides alone
  const double r = *rc::gen::inRange(25, 80) / 1000.0;
  const SurfaceTree tree(flip ? flipped : torus);
  const OffsetExterior exterior(tree, bounding_box(torus), r, closed);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d x = 0.6 * Eigen::Vector3d::Random();
    if (tree.closest(x)->distance <= r) continue;
    const auto found = exterior.contains(x);
    if (closed) RC_ASSERT(found.has_value());
    // Where the flood alone cannot tell, it says so; a centre of a cell is never more than a cell's diagonal away.
    if (found) RC_ASSERT(*found == (distance_to_ring(x, ring) > tube));
    if (!found) RC_ASSERT(tree.closest(x)->distance < r + std::max(r / 2, 1.0 / 256) * std::sqrt(3.0));
  }
}

TEST(OffsetExterior, TellsInsideFromOutsideWhereCubesAreLargerThanTheOffset) {
  const Shape torus = test::torus(0.35, 0.12, 32, 16);
  const Samples samples = sample_shape(torus, SampleSite::faces);
  const SurfaceTree tree(torus);
  for (const double r : {0.0005, 0.001, 0.002, 0.003, 0.004, 0.0055}) {
    const OffsetExterior exterior(tree, bounding_box(torus), r, true);
    int wrong = 0;
    for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
      for (const double height : {-1.5, 1.5}) {
        const Eigen::Vector3d x = samples.points.row(i) + height * r * samples.normals.row(i);
        wrong += exterior.contains(x) == (height > 0) ? 0 : 1;
      }
    }
    EXPECT_EQ(wrong, 0) << r;
  }
}

TEST(OffsetExterior, SeesAShellsVoidAsEnclosed) {
  const Shape hollow = test::joined({test::sphere(0.5, 3), test::flipped(test::sphere(0.25, 3))});
  const SurfaceTree tree(hollow);
  for (const bool closed : {true, false}) {
    const OffsetExterior exterior(tree, bounding_box(hollow), 0.05, closed);
    EXPECT_EQ(exterior.contains({0, 0, 0}), false);      // the void
    EXPECT_EQ(exterior.contains({0.375, 0, 0}), false);  // the wall
    EXPECT_EQ(exterior.contains({0.6, 0, 0}), true);
    EXPECT_EQ(exterior.contains({9, 9, 9}), true);
  }
}

TEST(OffsetExterior, SeesTheOverlapOfTwoPartsAsEnclosed) {
  Shape second = test::sphere(0.3, 3);
  second.vertices.col(0).array() += 0.3;
  const Shape both = test::joined({test::sphere(0.3, 3), second});
  const SurfaceTree tree(both);
  const OffsetExterior exterior(tree, bounding_box(both), 0.05, is_closed(both));
  EXPECT_EQ(exterior.contains({0.15, 0, 0}), false);
  EXPECT_EQ(exterior.is_outside_by_crossings({0.15, 0, 0}), false);
  EXPECT_EQ(exterior.is_outside_by_crossings({0.15, 0.5, 0}), true);
}

TEST(OffsetExterior, ClosesAGapThatIsNarrowerThanTwiceTheOffset) {
  // An open half sphere of two layers would be needed for a real shell: a sphere without its cap of radius 0.1 will do.
  Shape sphere = test::sphere(0.5, 4);
  Triangles kept(sphere.triangles.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index f = 0; f < sphere.triangles.rows(); ++f) {
    const Eigen::Vector3d corner = sphere.vertices.row(sphere.triangles(f, 0));
    if (corner.z() < 0 || corner.head<2>().norm() > 0.1) kept.row(count++) = sphere.triangles.row(f);
  }
  sphere.triangles = kept.topRows(count);
  ASSERT_FALSE(is_closed(sphere));
  const SurfaceTree tree(sphere);
  const OffsetExterior shut(tree, bounding_box(sphere), 0.15, false);
  EXPECT_EQ(shut.contains({0, 0, 0}), false);
  const OffsetExterior open(tree, bounding_box(sphere), 0.04, false);
  EXPECT_EQ(open.contains({0, 0, 0}), true);
}

}  // namespace
}  // namespace shapegauge
