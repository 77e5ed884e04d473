// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/core/render/camera.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Column and row of a point in the image.
Eigen::Vector2d projected(const Camera& camera, const Eigen::Vector3d& point) {
  const Eigen::Vector3d d = point - camera.top_left;
  return {d.dot(camera.right) / camera.pixel, -d.dot(camera.up) / camera.pixel};
}

TEST(Camera, AxesFollowTheViewAndUpDirections) {
  const Camera camera = camera_for(test::box({1, 2, 3}, 1), {.towards_viewer = {0, 0, 5}, .up = {0, 2, 0}});
  EXPECT_LT((camera.right - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((camera.up - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((camera.forward + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(camera.light.norm(), 1, 1e-12);
  EXPECT_GT(camera.light.dot(camera.up), 0);
  EXPECT_LT(camera.light.dot(camera.right), 0);
}

TEST(Camera, FitsTheShapeIntoTheImageUpToTheMargin) {
  const Shape box = test::box({4, 1, 1}, 1);  // wider than the image
  const RenderOptions options{.width = 200, .height = 100, .towards_viewer = {0, 0, 1}, .up = {0, 1, 0}, .margin = 0.1};
  const Camera camera = camera_for(box, options);
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  double top = left;
  double bottom = -left;
  for (const auto& vertex : box.vertices.rowwise()) {
    const Eigen::Vector2d pixel = projected(camera, vertex.transpose());
    left = std::min(left, pixel.x());
    right = std::max(right, pixel.x());
    top = std::min(top, pixel.y());
    bottom = std::max(bottom, pixel.y());
    EXPECT_GT((vertex.transpose() - camera.top_left).dot(camera.forward), 0) << "in front of the camera";
  }
  EXPECT_NEAR(left, 20, 1e-9);
  EXPECT_NEAR(right, 180, 1e-9);
  EXPECT_NEAR(top, 50 - 20, 1e-9);  // 160 pixels for 4 units
  EXPECT_NEAR(bottom, 50 + 20, 1e-9);
}

Shape moved(const Shape& part, const Eigen::Vector3d& move) {
  return test::transformed(part, 1, Eigen::Matrix3d::Identity(), move);
}

Shape turned(const Shape& shape, const Eigen::Matrix3d& rotation) {
  return test::transformed(shape, 1, rotation, {0, 0, 0});
}

constexpr double head_height = 2.4;
constexpr double feet_height = -3;

/// A standing figure with z up, broad along x: torso, head and legs.
Shape figure() {
  return test::joined({test::box({2, 0.8, 4}, 2), moved(test::box({0.7, 0.7, 0.8}, 1), {0, 0, head_height}),
                       moved(test::box({0.6, 0.6, 2}, 1), {-0.6, 0, feet_height}),
                       moved(test::box({0.6, 0.6, 2}, 1), {0.6, 0, feet_height})});
}

Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * EIGEN_PI / 180, axis).toRotationMatrix();
}

double cosine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.normalized().dot(b.normalized()); }

const std::vector<Eigen::Vector3d> directions_up = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0},
                                                    {0, 0, 1}, {0, 0, -1}, {1, 2, 3}};

TEST(UprightView, ShowsTheTopAboveTheBottomForAnyRotationAboutUp) {
  for (const Eigen::Vector3d& up : directions_up) {
    const Eigen::Matrix3d raise = rotation_between(Eigen::Vector3d::UnitZ(), up);
    for (int degrees = 0; degrees < 360; degrees += 40) {
      const Eigen::Matrix3d rotation = raise * rotation_about(Eigen::Vector3d::UnitZ(), degrees);
      const Shape shape = turned(figure(), rotation);
      const RenderOptions view = upright_view(shape, {.up = up});
      const Camera camera = camera_for(shape, view);
      const Eigen::Vector2d head = projected(camera, rotation * Eigen::Vector3d(0, 0, head_height));
      const Eigen::Vector2d feet = projected(camera, rotation * Eigen::Vector3d(0, 0, feet_height));
      EXPECT_LT(head.y(), feet.y() - 200) << up.transpose() << ", " << degrees;
      EXPECT_NEAR(head.x(), feet.x(), 1e-9);
      EXPECT_GT(std::abs(cosine(view.towards_viewer, rotation.col(1))), 0.85) << "the broad side";
      EXPECT_NEAR(cosine(view.towards_viewer, up), 0.39, 0.01) << "slightly from above";
    }
  }
}

TEST(UprightView, ShowsTheBroadSideThatFacesTheFront) {
  const Shape shape = figure();
  EXPECT_GT(cosine(upright_view(shape, {.up = {0, 0, 1}}).towards_viewer, {0, -1, 0}), 0.85);
  EXPECT_GT(cosine(upright_view(shape, {.up = {0, 0, -1}}).towards_viewer, {0, -1, 0}), 0.85);
  const Shape with_y_up = turned(shape, rotation_about(Eigen::Vector3d::UnitX(), -90));
  EXPECT_GT(cosine(upright_view(with_y_up, {.up = {0, 1, 0}}).towards_viewer, {0, 0, 1}), 0.85);
}

TEST(UprightView, ShowsShapesWithoutABroadSideFromTheFront) {
  const Eigen::Vector3d up(0, 0, 1);
  const Eigen::Vector3d front = upright_view(Shape{}, {.up = up}).towards_viewer;
  EXPECT_GT(cosine(front, {0, -1, 0}), 0.85);
  const Shape pillar = test::box({1, 1, 5}, 2);
  for (int degrees = 0; degrees < 90; degrees += 7) {
    EXPECT_EQ(upright_view(turned(pillar, rotation_about(up, degrees)), {.up = up}).towards_viewer, front) << degrees;
  }
  const Shape line{.vertices = Points{{0, 0, 0}, {0, 0, 1}, {0, 0, 3}}, .triangles = Triangles{{0, 1, 2}}};
  EXPECT_EQ(upright_view(line, {.up = up}).towards_viewer, front);
  EXPECT_EQ(upright_view({.vertices = line.vertices, .triangles = {}}, {.up = up}).towards_viewer, front);
  EXPECT_EQ(upright_view({.vertices = Points::Constant(3, 3, 1e200), .triangles = {}}, {.up = up}).towards_viewer,
            front);
}

TEST(UprightView, DoesNotShowFlatShapesEdgeOn) {
  const Shape plate{.vertices = Points{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}},
                    .triangles = Triangles{{0, 1, 2}, {0, 2, 3}}};
  for (const Eigen::Vector3d& up : directions_up) {
    const Camera camera = camera_for(plate, upright_view(plate, {.up = up}));
    EXPECT_TRUE(camera.top_left.allFinite() && std::isfinite(camera.pixel)) << up.transpose();
    EXPECT_GT(camera.pixel, 0.001) << "the plate is not seen edge-on";
  }
}

TEST(UprightView, DoesNotDependOnTheTriangulation) {
  const RenderOptions options{.up = {0, 0, 1}};
  const Eigen::Vector3d coarse = upright_view(test::box({3, 9, 1}, 1), options).towards_viewer;
  const Eigen::Vector3d fine = upright_view(test::box({3, 9, 1}, 8), options).towards_viewer;
  EXPECT_GT(cosine(coarse, fine), 1 - 1e-9);
  const Shape cloud = test::random_points(test::box({3, 9, 1}, 1), 20000, 1);
  EXPECT_GT(cosine(coarse, upright_view(cloud, options).towards_viewer), 0.99);
}

TEST(UprightView, KeepsImageSizeMarginAndUpDirection) {
  const RenderOptions view = upright_view(figure(), {.width = 7, .up = {0, 0, 2}, .margin = 0.2});
  EXPECT_EQ(view.width, 7);
  EXPECT_EQ(view.margin, 0.2);
  EXPECT_EQ(view.up, Eigen::Vector3d(0, 0, 2));
}

}  // namespace
}  // namespace shapegauge
