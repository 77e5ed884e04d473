// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Sets of models and measurements for tests of fusion and re-ranking.
namespace shapegauge::test {

/// Points in a plane: classes along curves, with distant ends and close neighbouring classes.
inline Eigen::MatrixXd arcs(Eigen::Index per_class, Eigen::Index classes, std::uint64_t seed) {
  RandomNumbers random(seed);
  Eigen::MatrixXd points(per_class * classes, 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double radius = 1 + 0.5 * static_cast<double>(i / per_class) + random.uniform(-0.05, 0.05);
    const double angle = random.uniform(0, 3);
    points.row(i) << radius * std::cos(angle), radius * std::sin(angle);
  }
  return points;
}

/// High-dimensional points about centres.
inline Eigen::MatrixXd clusters(Eigen::Index per_class, Eigen::Index classes, std::uint64_t seed) {
  RandomNumbers random(seed);
  const Eigen::Index dimensions = 20;
  const Eigen::MatrixXd centres =
      Eigen::MatrixXd::NullaryExpr(classes, dimensions, [&] { return random.uniform(-1, 1); });
  return Eigen::MatrixXd::NullaryExpr(per_class * classes, dimensions, [&](Eigen::Index i, Eigen::Index k) {
    return centres(i / per_class, k) + random.uniform(-1.2, 1.2);
  });
}

inline DistanceMatrix distances_of(const Eigen::MatrixXd& points) {
  DistanceMatrix matrix(points.rows(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    matrix.row(i) = (points.rowwise() - points.row(i)).rowwise().norm().transpose();
  }
  return matrix;
}

/// First tier: fraction of the nearest models that are of the query's class.
inline double first_tier(const DistanceMatrix& distances, Eigen::Index per_class) {
  double hits = 0;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(distances.cols()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    order.erase(order.begin() + i);
    std::ranges::stable_sort(order, {}, [&](Eigen::Index j) { return distances(i, j); });
    for (Eigen::Index k = 0; k + 1 < per_class; ++k) {
      hits += order[static_cast<std::size_t>(k)] / per_class == i / per_class ? 1 : 0;
    }
  }
  return hits / static_cast<double>(distances.rows() * (per_class - 1));
}

inline double largest_difference(const DistanceMatrix& a, const DistanceMatrix& b) {
  EXPECT_EQ(a.rows(), b.rows());
  return (a - b).lpNorm<Eigen::Infinity>();
}

inline constexpr double no_neighbour = std::numeric_limits<double>::infinity();

/// The k nearest others at finite distances, or fewer if there are not enough.
inline std::vector<Eigen::Index> nearest_of(const DistanceMatrix& distances, Eigen::Index model, std::size_t k) {
  std::vector<Eigen::Index> order;
  for (Eigen::Index j = 0; j < distances.cols(); ++j) {
    if (j != model && std::isfinite(distances(model, j))) order.push_back(j);
  }
  std::ranges::stable_sort(order, {}, [&](Eigen::Index j) { return distances(model, j); });
  order.resize(std::min(k, order.size()));
  return order;
}

inline double largest_finite(const DistanceMatrix& distances) {
  return distances.array().isFinite().select(distances, 0).maxCoeff();
}

inline DistanceMatrix mean_with_transposed(const DistanceMatrix& distances) {
  DistanceMatrix result = (distances + distances.transpose()) / 2;
  result.diagonal().setZero();
  return result;
}

/// The distances with two thirds of the pairs infinite, all of those of the model 7 and those between two halves.
inline DistanceMatrix with_gaps(DistanceMatrix distances) {
  RandomNumbers random(11);
  const Eigen::Index half = distances.rows() / 2;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (i == 7 || j == 7 || (i < half) != (j < half) || random.uniform(0, 1) < 0.3) {
        distances(i, j) = distances(j, i) = no_neighbour;
      }
    }
  }
  return distances;
}

/// Expects the same entries to be infinite and the others to be equal within the tolerance.
inline void expect_near(const DistanceMatrix& found, const DistanceMatrix& expected, double tolerance) {
  ASSERT_EQ(found.rows(), expected.rows());
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    for (Eigen::Index j = 0; j < found.cols(); ++j) {
      if (found(i, j) == expected(i, j)) continue;
      ASSERT_LE(std::abs(found(i, j) - expected(i, j)), tolerance) << i << " " << j << " " << found(i, j);
      ASSERT_TRUE(std::isfinite(found(i, j))) << i << " " << j;
    }
  }
}

inline DistanceMatrix diffused_by_rows(const DistanceMatrix& matrix, const DiffusionOptions& options = {}) {
  DistanceMatrix result(matrix.rows(), matrix.cols());
  diffuse(matrix.rows(), rows_of(matrix), options,
          [&](Eigen::Index first, const DistanceMatrix& rows) { result.middleRows(first, rows.rows()) = rows; });
  return result;
}

/// Random permutation of 0 to `size` - 1.
inline std::vector<Eigen::Index> random_order(Eigen::Index size, std::uint64_t seed) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  RandomNumbers random(seed);
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
  return order;
}

}  // namespace shapegauge::test
