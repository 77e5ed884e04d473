// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/preparation/tube_area.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(ScaledToUnitArea, HasAreaOneForEveryInputScale) {
  for (const double scale : {1e-30, 1e-3, 1.0, 1e30}) {
    const Shape shape = prepare_shape(test::box(scale * Eigen::Vector3d(1, 2, 3), 2), {}).shape;
    EXPECT_NEAR(surface_area(shape), 1, 1e-14) << scale;
  }
}

TEST(ScaledToUnitArea, ScalesAboutTheOriginAndKeepsTriangles) {
  const Shape box = test::transformed(test::box({1, 1, 1}, 1), 2, Eigen::Matrix3d::Identity(), {5, 6, 7});
  const Shape unit = prepare_shape(box, {}).shape;
  EXPECT_TRUE(unit.vertices.isApprox(box.vertices / std::sqrt(24.0), 1e-14));
  EXPECT_EQ(unit.triangles, box.triangles);
}

TEST(ScaledToUnitArea, UsesTheEstimatedAreaOfClouds) {
  for (const double scale : {1e-30, 1.0, 1e30}) {
    Shape cloud{test::box(scale * Eigen::Vector3d(1, 2, 3), 5).vertices, {}, {}};
    cloud.normals = Points::Ones(cloud.vertices.rows(), 3).rowwise().normalized();
    const Shape unit = prepare_shape(cloud, {}).shape;
    EXPECT_NEAR(point_weights(unit.vertices).sum(), 1, 1e-12) << scale;
    EXPECT_EQ(unit.normals, cloud.normals);
  }
}

TEST(ScaledToUnitArea, RefusesACloudWithoutArea) {
  for (const Eigen::Index points : {1, 30}) {
    EXPECT_THAT(
        [&] {
          prepare_shape({Points::Ones(points, 3), {}, {}}, {});
        },
        ThrowsMessage<InputError>(HasSubstr("needs distinct points")));
  }
  Points huge = Points::Random(20, 3) * 1e200;
  EXPECT_THROW(prepare_shape({huge, {}, {}}, {}), InputError);
}

TEST(ScaledToUnitArea, RefusesShapesWithZeroOrNonFiniteArea) {
  EXPECT_THROW(prepare_shape(Shape{}, {}), InputError);
  EXPECT_THROW(prepare_shape(test::box({1, 0, 0}, 1), {}), InputError);
  EXPECT_THROW(prepare_shape(test::box({1e200, 1e200, 1}, 1), {}), InputError);
  Shape with_nan = test::box({1, 1, 1}, 1);
  with_nan.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(prepare_shape(with_nan, {}), InputError);
}

TEST(PrepareShape, ScalesTheEstimatedAreaToOne) {
  const Shape box = test::box({1, 2, 3}, 2);
  const PreparedShape by_area = prepare_shape(box, {.scale = ScaleEstimate::area});
  EXPECT_NEAR(by_area.area, 22, 1e-12);
  EXPECT_NEAR(surface_area(by_area.shape), 1, 1e-14);
  const PreparedShape by_tube = prepare_shape(box, {.scale = ScaleEstimate::tube_area});
  EXPECT_EQ(by_tube.area, tube_area(box));
  EXPECT_NEAR(tube_area(by_tube.shape), 1, 1e-9);
}

}  // namespace

}  // namespace shapegauge
