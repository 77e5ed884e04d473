// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/render/camera.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Column and row of a point in the image.
Eigen::Vector2d projected(const Camera& camera, const Eigen::Vector3d& point) {
  const Eigen::Vector3d d = point - camera.top_left;
  return {d.dot(camera.right) / camera.pixel, -d.dot(camera.up) / camera.pixel};
}

TEST(Camera, AxesAreARotationTowardsTheShape) {
  const Camera camera = camera_for(test::box({1, 2, 3}, 1), {.towards_viewer = {0, 0, 5}, .up = {0, 2, 0}});
  EXPECT_LT((camera.right - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((camera.up - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((camera.forward + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(camera.light.norm(), 1, 1e-12);
  EXPECT_GT(camera.light.dot(camera.up), 0);
  EXPECT_LT(camera.light.dot(camera.right), 0);
}

TEST(Camera, TheShapeFillsTheImageUpToTheMargin) {
  const Shape box = test::box({4, 1, 1}, 1);  // wider than the image
  const RenderOptions options{.width = 200, .height = 100, .towards_viewer = {0, 0, 1}, .up = {0, 1, 0}, .margin = 0.1};
  const Camera camera = camera_for(box, options);
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  double top = left;
  double bottom = -left;
  for (const auto& vertex : box.vertices.rowwise()) {
    const Eigen::Vector2d place = projected(camera, vertex.transpose());
    left = std::min(left, place.x());
    right = std::max(right, place.x());
    top = std::min(top, place.y());
    bottom = std::max(bottom, place.y());
    EXPECT_GT((vertex.transpose() - camera.top_left).dot(camera.forward), 0) << "in front of the camera";
  }
  EXPECT_NEAR(left, 20, 1e-9);
  EXPECT_NEAR(right, 180, 1e-9);
  EXPECT_NEAR(top, 50 - 20, 1e-9);  // 160 pixels for 4 units
  EXPECT_NEAR(bottom, 50 + 20, 1e-9);
}

}  // namespace
}  // namespace shapegauge
