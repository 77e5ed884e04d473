// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/boundary_smoothing.h"
#include "tests/segmentation/hand_made_surface.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using Labels = std::vector<std::int32_t>;

double border_length(const SurfaceGraph& graph, const Labels& labels) {
  double length = 0;
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    for (const SurfaceLink& link : graph.links_of(i)) {
      if (labels[static_cast<std::size_t>(i)] != labels[static_cast<std::size_t>(link.to)]) length += link.length / 2;
    }
  }
  return length;
}

/// A torus about z, and its halves to the left and to the right, between which waves run around the tube.
ThickSurface torus() { return thick_surface(test::torus(3, 1, 60, 180)); }

Labels wavy_halves(const ThickSurface& surface, double amplitude) {
  Labels labels;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    const auto position = surface.graph.samples.points.row(i);
    const double around = std::atan2(position.z(), std::hypot(position.x(), position.y()) - 3);
    labels.push_back(position.x() > amplitude * std::sin(5 * around) ? 1 : 0);
  }
  return labels;
}

TEST(BoundarySmoothing, ShortensAWavyBorder) {
  const ThickSurface surface = torus();
  const double amplitude = 0.2;
  const Labels wavy = wavy_halves(surface, amplitude);
  const Labels smooth = smooth_boundaries(surface, wavy, {});
  EXPECT_LT(border_length(surface.graph, smooth), 0.9 * border_length(surface.graph, wavy));
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    // Parts grow by the width, 0.03 units, and an edge.
    if (std::abs(surface.graph.samples.points(i, 0)) < amplitude + 0.04 * surface.unit) continue;
    EXPECT_EQ(smooth[static_cast<std::size_t>(i)], wavy[static_cast<std::size_t>(i)]);
  }
}

/// Five nodes in a row, 0.01 units apart, whose borders are of these lengths: two that are too large to change, and
/// three of 0.2 square units.
ThickSurface row(const std::vector<double>& lengths) {
  const double unit = 10;
  std::vector<double> border_lengths;
  for (const double length : lengths) border_lengths.push_back(unit * length);
  return test::hand_made_surface(
      test::hand_made_graph({200, 200, 20, 20, 20}, test::chain(border_lengths, 0.01 * unit)), unit);
}

TEST(BoundarySmoothing, MovesABorderIfTheShorterLengthOutweighsTheArea) {
  // Node 2 costs 0.2 * 0.01 / 0.03 = 0.0667 where it goes over, and saves 0.9 of border.
  const ThickSurface surface = row({1, 1, 0.1, 1});
  const Labels labels = {0, 0, 1, 1, 1};
  EXPECT_EQ(smooth_boundaries(surface, labels, {.width = 0.03, .strength = 0.07}), labels);
  EXPECT_EQ(smooth_boundaries(surface, labels, {.width = 0.03, .strength = 0.08}), (Labels{0, 0, 0, 1, 1}));
  EXPECT_EQ(smooth_boundaries(surface, labels, {.width = 0.025, .strength = 0.08}), labels) << "0.08 against 0.072";
  EXPECT_EQ(smooth_boundaries(surface, labels, {.width = 0.009, .strength = 9}), labels) << "out of reach";
}

TEST(BoundarySmoothing, CostIncludesBordersWithNodesOfFixedLabel) {
  // Nodes 1 and 2 may change. Node 2 costs 0.2 * 0.01 / 0.015 = 0.1333, and saves 0.9 of border.
  const ThickSurface surface = row({1, 1, 0.1, 1});
  const Labels labels = {0, 0, 1, 1, 1};
  EXPECT_EQ(smooth_boundaries(surface, labels, {.width = 0.015, .strength = 0.145}), labels);
  EXPECT_EQ(smooth_boundaries(surface, labels, {.width = 0.015, .strength = 0.152}), (Labels{0, 0, 0, 1, 1}));
}

TEST(BoundarySmoothing, MovesABorderByTwoNodesOnlyIfTheCostFalls) {
  // Nodes 2 and 3 cost 0.2 * (0.01 + 0.02) / 0.03 = 0.2 together, and save 0.9 of border.
  const ThickSurface surface = row({1, 1, 1, 0.1});
  const Labels labels = {0, 0, 1, 1, 1};
  EXPECT_EQ(smooth_boundaries(surface, labels, {.width = 0.03, .strength = 0.21}), labels);
  EXPECT_EQ(smooth_boundaries(surface, labels, {.width = 0.03, .strength = 0.23}), (Labels{0, 0, 0, 0, 1}));
}

TEST(BoundarySmoothing, LowersTheCostOfBordersAtConcavities) {
  // The link between nodes 2 and 3 turns by 0.1 over 0.01: a curvature of 10.
  ThickSurface surface = row({1, 1, 1, 1});
  surface.smooth_normals.row(2) << std::sin(0.05), 0, std::cos(0.05);
  surface.smooth_normals.row(3) << -std::sin(0.05), 0, std::cos(0.05);
  surface.smooth_normals.topRows(2).rowwise() = surface.smooth_normals.row(2);
  surface.smooth_normals.row(4) = surface.smooth_normals.row(3);
  const Labels labels = {0, 0, 1, 1, 1};
  const auto smoothed = [&](double strength, double concavity) {
    return smooth_boundaries(surface, labels, {.width = 0.03, .strength = strength, .concavity = concavity});
  };
  EXPECT_EQ(smoothed(0.13, 10), labels) << "0.065 saved";
  EXPECT_EQ(smoothed(0.14, 10), (Labels{0, 0, 0, 1, 1})) << "0.07 saved";
  EXPECT_EQ(smoothed(0.14, 30), labels) << "a quarter saved";
  surface.smooth_normals.col(0) *= -1;  // a ridge
  EXPECT_EQ(smoothed(0.14, 10), labels);
}

TEST(BoundarySmoothing, KeepsTheLabelsUnchangedForWidthZero) {
  const ThickSurface surface = torus();
  const Labels wavy = wavy_halves(surface, 0.2);
  EXPECT_EQ(smooth_boundaries(surface, wavy, {.width = 0}), wavy);
}

TEST(BoundarySmoothing, KeepsASinglePartUnchanged) {
  const ThickSurface surface = thick_surface(test::sphere(1, 2));
  const Labels one(static_cast<std::size_t>(surface.graph.size()), 0);
  EXPECT_EQ(smooth_boundaries(surface, one, {}), one);
}

TEST(BoundarySmoothing, DoesNotRemoveAPartOfASingleNode) {
  const ThickSurface surface = thick_surface(test::sphere(1, 3));
  Labels labels(static_cast<std::size_t>(surface.graph.size()), 0);
  labels[17] = 1;
  const Labels smooth = smooth_boundaries(surface, labels, {.strength = 100});
  EXPECT_EQ(std::set(smooth.begin(), smooth.end()).size(), 2U);
}

TEST(BoundarySmoothing, RefusesOptionsOutOfRange) {
  const ThickSurface surface = thick_surface(test::sphere(1, 0));
  const Labels labels(20, 0);
  EXPECT_THROW(smooth_boundaries(surface, labels, {.width = -1}), InputError);
  EXPECT_THROW(smooth_boundaries(surface, labels, {.strength = NAN}), InputError);
  EXPECT_THROW(smooth_boundaries(surface, labels, {.concavity = 0}), InputError);
  EXPECT_THROW(smooth_boundaries(surface, Labels{0}, {}), ArgumentError);
  EXPECT_THROW(smooth_boundaries(surface, Labels(20, -1), {}), ArgumentError);
}

TEST(BoundarySmoothing, MovesABorderToAFoldOnlyIfItIsConcaveEnough) {
  // Six nodes in a row, folded between the fourth and the fifth; the border is one node before.
  ThickSurface row;
  row.graph.samples.points = Points::Zero(6, 3);
  row.graph.samples.points.col(0) << 0, 1, 2, 3, 4, 5;
  row.graph.samples.weights = Eigen::VectorXd::Ones(6);
  row.unit = std::sqrt(6.0);
  row.smooth_normals.resize(6, 3);
  row.graph.first = {0};
  for (std::int32_t i = 0; i < 6; ++i) {
    row.smooth_normals.row(i) = Eigen::RowVector3d(i < 4 ? 0.5 : -0.5, 0, 1).normalized();
    if (i > 0) row.graph.links.push_back({.to = i - 1, .length = 1, .distance = 1});
    if (i < 5) row.graph.links.push_back({.to = i + 1, .length = 1, .distance = 1});
    row.graph.first.push_back(row.graph.links.size());
  }
  const Labels labels = {0, 0, 0, 1, 1, 1};
  EXPECT_EQ(smooth_boundaries(row, labels, {.width = 0.5, .strength = 1, .concavity = 1e-3}),
            (Labels{0, 0, 0, 0, 1, 1}));
  EXPECT_EQ(smooth_boundaries(row, labels, {.width = 0.5, .strength = 1, .concavity = 1e3}), labels);
}

}  // namespace
}  // namespace shapegauge
