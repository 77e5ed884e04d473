#include <Eigen/LU>
#include <gtest/gtest.h>

#include "shapegauge/core/perturbation/random_vectors.h"

namespace shapegauge {
namespace {

constexpr int count = 100000;

TEST(GaussianVector, HasMeanZeroAndUnitCovariance) {
  RandomNumbers random(3);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  int beyond_two = 0;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d x = gaussian_vector(random);
    sum += x;
    squares += x * x.transpose();
    if (std::abs(x[2]) > 2) ++beyond_two;
  }
  // Standard deviations over sqrt(count): 0.0032 of a mean, 0.0045 of a variance; five of them.
  EXPECT_LT((sum / count).cwiseAbs().maxCoeff(), 0.016);
  EXPECT_LT((squares / count - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.023);
  EXPECT_NEAR(beyond_two / static_cast<double>(count), 0.0455, 0.0033);
}

TEST(PointInUnitBall, IsUniformInTheBall) {
  RandomNumbers random(4);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int in_half_radius = 0;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d x = point_in_unit_ball(random);
    ASSERT_LE(x.norm(), 1);
    sum += x;
    if (x.norm() < 0.5) ++in_half_radius;
  }
  // A coordinate's variance is 1/5; an eighth of the volume is in half the radius.
  EXPECT_LT((sum / count).cwiseAbs().maxCoeff(), 0.0071);
  EXPECT_NEAR(in_half_radius / static_cast<double>(count), 0.125, 0.0053);
}

TEST(UniformRotation, TurnsADirectionToAllDirectionsAlike) {
  RandomNumbers random(5);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Matrix3d r = uniform_rotation(random);
    if (i < 100) {
      ASSERT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      ASSERT_NEAR(r.determinant(), 1, 1e-14);
    }
    sum += r;
    squares += r.cwiseProduct(r);
  }
  // Every entry is uniform in [-1, 1]: mean 0, variance 1/3 (of which the variance is 4/45).
  EXPECT_LT((sum / count).cwiseAbs().maxCoeff(), 0.0092);
  EXPECT_LT((squares / count - Eigen::Matrix3d::Constant(1. / 3)).cwiseAbs().maxCoeff(), 0.0048);
}

}  // namespace
}  // namespace shapegauge
