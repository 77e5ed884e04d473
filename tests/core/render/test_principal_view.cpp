#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "shapegauge/core/render/principal_view.h"
#include "tests/core/random_points.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

/// A shape without symmetries: a body, a head at one end, something on its back and at its side.
Shape lopsided() {
  const auto placed = [](const Shape& part, const Eigen::Vector3d& move) {
    return test_shapes::transformed(part, 1, Eigen::Matrix3d::Identity(), move);
  };
  return test_shapes::joined({test_shapes::box({6, 2, 1}, 2), placed(test_shapes::sphere(0.9, 2), {4, 0.4, 0}),
                              placed(test_shapes::box({0.5, 1, 0.5}, 1), {1, 1.6, 0}),
                              placed(test_shapes::box({0.4, 0.4, 0.8}, 1), {0.5, 0, 1})});
}

double cosine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.normalized().dot(b.normalized()); }

TEST(PrincipalView, TheLongestAxisLiesAcrossTheImageAndTheShortestTowardsTheViewer) {
  const RenderOptions view = principal_view(test_shapes::box({3, 9, 1}, 2));
  EXPECT_GT(std::abs(view.up.x()), 0.999);
  const Eigen::Vector3d across = view.up.cross(view.towards_viewer);
  EXPECT_GT(std::abs(cosine(across, Eigen::Vector3d(0, 1, 0))), 0.9);
  EXPECT_GT(std::abs(cosine(view.towards_viewer, Eigen::Vector3d(0, 0, 1))), 0.85);
}

TEST(PrincipalView, FollowsTheShape) {
  const Shape shape = lopsided();
  const RenderOptions view = principal_view(shape);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 2, -1).normalized()) *
                                Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()))
                                   .toRotationMatrix();
  const RenderOptions turned = principal_view(test_shapes::transformed(shape, 3, turn, {5, -7, 11}));
  EXPECT_GT(cosine(turned.up, turn * view.up), 1 - 1e-9);
  EXPECT_GT(cosine(turned.towards_viewer, turn * view.towards_viewer), 1 - 1e-9);
}

TEST(PrincipalView, DoesNotDependOnTheTriangulation) {
  const Shape coarse = test_shapes::box({3, 9, 1}, 1);
  const Shape fine = test_shapes::box({3, 9, 1}, 8);
  EXPECT_GT(cosine(principal_view(coarse).towards_viewer, principal_view(fine).towards_viewer), 1 - 1e-9);
}

TEST(PrincipalView, OfACloudIsAboutThatOfItsSurface) {
  const Shape shape = lopsided();
  const RenderOptions of_surface = principal_view(shape);
  const RenderOptions of_cloud = principal_view(test_shapes::random_points(shape, 20000, 1));
  EXPECT_GT(cosine(of_surface.up, of_cloud.up), 0.99);
  EXPECT_GT(cosine(of_surface.towards_viewer, of_cloud.towards_viewer), 0.99);
}

TEST(PrincipalView, OtherOptionsStayAndNothingToLookAtIsNoError) {
  const RenderOptions options{.width = 7, .margin = 0.2};
  EXPECT_EQ(principal_view(lopsided(), options).width, 7);
  EXPECT_EQ(principal_view(lopsided(), options).margin, 0.2);
  EXPECT_EQ(principal_view(Shape{}, options).up, options.up);
}

}  // namespace
}  // namespace shapegauge
