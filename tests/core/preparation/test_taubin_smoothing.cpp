#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/error.h"
#include "shapegauge/core/preparation/taubin_smoothing.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

/// The factor that the documentation promises for a frequency.
double gain(double k, double pass_band) {
  const double rounds = std::ceil(2 / pass_band) + 3;
  return std::pow((1 - k / 2) * (1 + k / (2 - pass_band)), rounds);
}

/// A ring of vertices that are each other's neighbours.
VertexNeighbours ring(std::int32_t n) {
  VertexNeighbours result;
  for (std::int32_t v = 0; v < n; ++v) {
    result.first.push_back(result.neighbours.size());
    result.neighbours.push_back((v + n - 1) % n);
    result.neighbours.push_back((v + 1) % n);
  }
  result.first.push_back(result.neighbours.size());
  return result;
}

TEST(TaubinSmoothing, ScalesAWaveOnARingByTheTransferFunction) {
  constexpr int n = 60;
  for (const double pass_band : {0.02, 0.1, 0.3}) {
    for (const int waves : {0, 1, 3, 7, 12, 20, 30}) {
      const double k = 1 - std::cos(2 * std::numbers::pi * waves / n);
      Points values(n, 3);
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * waves * i / n;
        values.row(i) << std::cos(angle), std::sin(angle), 5;
      }
      const Points smoothed = taubin_smoothed(values, ring(n), pass_band);
      values.leftCols(2) *= gain(k, pass_band);
      EXPECT_LT((smoothed - values).cwiseAbs().maxCoeff(), 1e-12) << pass_band << " " << waves;
    }
  }
}

TEST(TaubinSmoothing, ScalesAWaveOnATorusMeshByTheTransferFunction) {
  constexpr int around = 24;
  constexpr int along = 36;
  const VertexNeighbours neighbours = vertex_neighbours(test_shapes::torus(2, 0.7, around, along));
  for (const auto& [p, q] : {std::pair(1, 0), std::pair(2, 3), std::pair(5, 7), std::pair(18, 12)}) {
    const double a = 2 * std::numbers::pi * p / along;
    const double b = 2 * std::numbers::pi * q / around;
    // The diagonals join (i, j) and (i + 1, j + 1).
    const double k = 1 - (std::cos(a) + std::cos(b) + std::cos(a + b)) / 3;
    Points values = Points::Zero(along * around, 3);
    for (int i = 0; i < along; ++i) {
      for (int j = 0; j < around; ++j) values(i * around + j, 0) = std::cos(a * i + b * j);
    }
    const Points smoothed = taubin_smoothed(values, neighbours, 0.1);
    EXPECT_LT((smoothed - gain(k, 0.1) * values).cwiseAbs().maxCoeff(), 1e-12) << p << " " << q;
  }
}

TEST(TaubinSmoothing, KeepsWhatIsInThePassBandAndFadesWhatIsNot) {
  for (const double pass_band : {0.01, 0.02, 0.05, 0.1}) {
    for (double k = 0; k < 2; k += 0.01) {
      if (k < pass_band) {
        EXPECT_GE(gain(k, pass_band), 1 - 1e-12);
        EXPECT_LE(gain(k, pass_band), 1.02);
      } else {
        EXPECT_LE(std::abs(gain(k, pass_band)), 1 + 1e-12);
      }
      if (k > 0.75) {
        EXPECT_LE(std::abs(gain(k, pass_band)), 0.1);
      }
    }
  }
}

TEST(TaubinSmoothing, DoesNotShrinkASphere) {
  const Shape sphere = test_shapes::sphere(1, 4);
  const Points smoothed = taubin_smoothed(sphere.vertices, vertex_neighbours(sphere), 0.1);
  // As many rounds of plain averaging take 3 % off.
  EXPECT_NEAR(smoothed.rowwise().norm().mean(), 1, 3e-3);
  EXPECT_LT((smoothed - sphere.vertices).rowwise().norm().maxCoeff(), 1e-2);
}

TEST(TaubinSmoothing, LeavesVerticesWithoutNeighboursAndMovesThoseAtOnePlaceTogether) {
  Shape soup = test_shapes::soup(test_shapes::box({1, 2, 3}, 3));
  soup.vertices.conservativeResize(soup.vertices.rows() + 1, 3);
  soup.vertices.bottomRows(1) << 0.1, 0.2, 0.3;
  const Points smoothed = taubin_smoothed(soup.vertices, vertex_neighbours(soup), 0.1);
  EXPECT_EQ(smoothed.bottomRows(1), soup.vertices.bottomRows(1));
  const Shape mesh = test_shapes::box({1, 2, 3}, 3);
  const Points expected = taubin_smoothed(mesh.vertices, vertex_neighbours(mesh), 0.1);
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) {
    EXPECT_LT((smoothed.row(i) - expected.row(mesh.triangles(i / 3, i % 3))).norm(), 1e-12);
  }
}

TEST(TaubinSmoothing, RefusesAPassBandOutOfRange) {
  for (const double pass_band : {0.0, 1.0, -0.1, std::nan("")}) {
    EXPECT_THROW(taubin_smoothed(Points::Zero(60, 3), ring(60), pass_band), InputError);
  }
}

}  // namespace
}  // namespace shapegauge
