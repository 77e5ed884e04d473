// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/proxy/sample_connectivity.h"

namespace shapegauge {

namespace {

/// 10 x 10 samples of no sheet: position(u, v) for u and v from 0 to 9.
template <typename Position>
DenseSamples grid_of(const Eigen::RowVector3d& normal, Position position) {
  DenseSamples samples{
      Points(100, 3), normal.replicate(100, 1), Eigen::VectorXd::Ones(100), std::vector<std::int32_t>(100, -1), {}};
  for (int i = 0; i < 100; ++i) samples.points.row(i) = position(i % 10, i / 10);
  return samples;
}

DenseSamples joined(const DenseSamples& a, const DenseSamples& b) {
  DenseSamples both{Points(200, 3), Points(200, 3), Eigen::VectorXd::Ones(200), std::vector<std::int32_t>(200, -1), {}};
  both.points << a.points, b.points;
  both.normals << a.normals, b.normals;
  return both;
}

DenseSamples floor_grid() {
  return grid_of({0, 0, 1}, [](double u, double v) { return Eigen::RowVector3d(u, v, 0); });
}

/// Sample in the middle of a grid's border u = 0.
constexpr std::int32_t at_border = 40;

bool connected(const DenseSamples& samples, std::int32_t from, std::int32_t to) {
  const Eigen::Vector3d centre = (samples.points.row(from) + samples.points.row(to)).transpose() / 2;
  const double distance = (samples.points.row(from) - samples.points.row(to)).norm();
  return SampleConnectivity(samples).connected_in_ball(from, to, centre, distance);
}

TEST(SampleConnectivity, ConnectsSamplesOfAFlatGrid) {
  EXPECT_TRUE(connected(floor_grid(), 0, 99));
  EXPECT_TRUE(connected(floor_grid(), at_border, at_border + 3));
}

TEST(SampleConnectivity, ConnectsSamplesOnTwoSidesOfAnEdge) {
  const DenseSamples wall = grid_of({1, 0, 0}, [](double u, double v) { return Eigen::RowVector3d(-0.5, v, u + 0.5); });
  EXPECT_TRUE(connected(joined(floor_grid(), wall), at_border + 1, 100 + at_border + 1));
}

TEST(SampleConnectivity, DoesNotConnectTheSidesOfAThinPlate) {
  const DenseSamples below = grid_of({0, 0, 1}, [](double u, double v) { return Eigen::RowVector3d(u, v, -0.5); });
  EXPECT_FALSE(connected(joined(floor_grid(), below), 44, 144));
  EXPECT_FALSE(connected(joined(floor_grid(), below), 44, 100 + 46));
}

TEST(SampleConnectivity, IgnoresPathsBeyondTheSearchRadius) {
  // On both sides of a slit 3 wide, connected at its end.
  const DenseSamples right = grid_of({0, 0, 1}, [](double u, double v) { return Eigen::RowVector3d(12 + u, v, 0); });
  DenseSamples horseshoe = joined(floor_grid(), right);
  horseshoe.points.row(0) << 10, 0, 0;
  horseshoe.points.row(110) << 11, 0, 0;
  EXPECT_TRUE(connected(horseshoe, 9, 100)) << "at the end";
  EXPECT_FALSE(connected(horseshoe, 39, 130)) << "3 from the end, beyond the ball's radius of 2.25";
  EXPECT_FALSE(connected(horseshoe, 99, 190)) << "at the other end";
}

}  // namespace

}  // namespace shapegauge
