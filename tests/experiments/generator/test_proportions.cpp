#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "shapegauge/experiments/generator/proportions.h"

namespace shapegauge {
namespace {

TEST(Proportions, StretchEachKindOfLimbByAFewPercentAndKeepTheJointsTogether) {
  Skeleton s;
  add_limb(s, {.kind = "body", .nodes = {{{0, 0, 0}, 0.5}, {{2, 0, 0}, 0.5}}});
  for (const double x : {0.5, 1.5}) {
    add_limb(s, {.kind = "leg", .parent = 0, .nodes = {{{x, 0, 0}, 0.2}, {{x, 0, -1}, 0.2}}});
  }
  RestPose rest;
  rest.tree = bones_of(s);
  rest.points.resize(4, 3);
  rest.points << 2, 0, 0, 0, 0.5, 0, 0.5, 0, -1, 1.5, 0, -1;
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(4, 3);
  weights(0, 0) = weights(1, 0) = weights(2, 1) = weights(3, 2) = 1;
  RandomNumbers random(9);
  const RestPose drawn = draw_individual(s, rest, weights, random);
  const double body_length = drawn.points(0, 0) / 2;
  const double body_girth = drawn.points(1, 1) / 0.5;
  const double leg_length = -drawn.points(2, 2);
  for (const double factor : {body_length, body_girth, leg_length}) {
    EXPECT_NE(factor, 1);
    EXPECT_NEAR(factor, 1, 0.07);
  }
  EXPECT_NEAR(-drawn.points(3, 2), leg_length, 1e-15);  // both legs are of a kind
  EXPECT_NEAR(drawn.tree.bones[1].joint.x(), 0.5 * body_length, 1e-15);
  EXPECT_NEAR(drawn.points(2, 0), 0.5 * body_length, 1e-15);
  EXPECT_NEAR(drawn.points(3, 0), 1.5 * body_length, 1e-15);
}

}  // namespace
}  // namespace shapegauge
