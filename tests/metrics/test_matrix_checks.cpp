// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>

#include "shapegauge/metrics/matrix_checks.h"

namespace shapegauge {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

// Distances of points on a line: nothing to warn about.
Matrix sound(Eigen::Index count) {
  return Matrix::NullaryExpr(count, count, [](Eigen::Index i, Eigen::Index j) {
    return std::abs(static_cast<double>(i * i) - static_cast<double>(j * j));
  });
}

// Findings for a matrix passed in blocks of rows.
MatrixFindings check_matrix(const Matrix& distances, bool square, Eigen::Index together = 1000) {
  MatrixChecks checks(square);
  for (Eigen::Index first = 0; first < distances.rows(); first += together) {
    const Matrix rows = distances.middleRows(first, std::min(together, distances.rows() - first));
    checks.add(rows);
    const Eigen::Index behind = distances.rows() - first;
    if (square) checks.compare(rows, first, distances.block(first, first, behind, rows.rows()));
  }
  return checks.findings();
}

TEST(MatrixChecks, FindNoAnomaliesInAValidMatrix) {
  const MatrixFindings found = check_matrix(sound(200), true);
  EXPECT_EQ(found.infinite, 0);
  EXPECT_EQ(found.negative, 0);
  EXPECT_EQ(found.asymmetric_pairs, 0);
  EXPECT_EQ(found.nonzero_diagonal, 0);
  EXPECT_EQ(found.rows_nearest_to_others, 0);
  EXPECT_THAT(found.equal_rows, IsEmpty());
  EXPECT_THAT(found.constant_rows, IsEmpty());
}

TEST(MatrixChecks, CountEachKindOfAnomaly) {
  Matrix distances = sound(200);
  distances(3, 150) = -2;
  distances(7, 9) = std::numeric_limits<double>::infinity();
  distances(4, 4) = 0.5;
  const MatrixFindings found = check_matrix(distances, true);
  EXPECT_EQ(found.negative, 1);
  EXPECT_EQ(found.infinite, 1);
  EXPECT_EQ(found.asymmetric_pairs, 2);
  EXPECT_EQ(found.largest_asymmetry, 150 * 150 - 9 + 2);
  EXPECT_EQ(found.nonzero_diagonal, 1);
}

TEST(MatrixChecks, FindDuplicateRows) {
  Matrix distances = sound(100);
  for (const Eigen::Index copy : {60, 80}) {
    distances.row(copy) = distances.row(10).eval();
    distances.col(copy) = distances.col(10).eval();
  }
  EXPECT_THAT(check_matrix(distances, true).equal_rows, ElementsAre(Pair(60, 10), Pair(80, 10)));
}

TEST(MatrixChecks, FindRowsOfEqualDistances) {
  Matrix distances = sound(50);
  distances.row(20).setConstant(3);
  distances(20, 20) = 0;
  EXPECT_THAT(check_matrix(distances, true).constant_rows, ElementsAre(20));
  EXPECT_THAT(check_matrix(distances, false).constant_rows, IsEmpty());
  EXPECT_THAT(check_matrix(Matrix::Zero(2, 2), true).constant_rows, IsEmpty());
}

TEST(MatrixChecks, FindRowsOfInfiniteDistances) {
  Matrix distances = sound(50);
  distances.row(20).setConstant(std::numeric_limits<double>::infinity());
  distances(20, 20) = 0;
  distances(7, 9) = std::numeric_limits<double>::infinity();
  const MatrixFindings found = check_matrix(distances, true);
  EXPECT_THAT(found.infinite_rows, ElementsAre(20));
  EXPECT_THAT(found.constant_rows, IsEmpty());
  EXPECT_EQ(found.infinite, 1);
  EXPECT_THAT(check_matrix(Matrix::Zero(1, 1), true).infinite_rows, IsEmpty());
}

TEST(MatrixChecks, IgnoreAsymmetryByRounding) {
  Matrix distances = sound(50);
  distances(3, 40) *= 1 + 1e-15;
  EXPECT_EQ(check_matrix(distances, true).asymmetric_pairs, 0);
  EXPECT_EQ(check_matrix(distances, true).largest_asymmetry, 0);
  distances(8, 30) *= 1 + 1e-9;
  EXPECT_EQ(check_matrix(distances, true).asymmetric_pairs, 2);
  distances = sound(50);
  distances(8, 30) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check_matrix(distances, true).asymmetric_pairs, 1);
}

TEST(MatrixChecks, DetectATriangularMatrix) {
  EXPECT_TRUE(check_matrix(sound(50).triangularView<Eigen::Lower>(), true).triangular);
  EXPECT_TRUE(check_matrix(sound(50).triangularView<Eigen::Upper>(), true, 7).triangular);
  EXPECT_FALSE(check_matrix(sound(50), true).triangular);
  Matrix distances = sound(50);
  distances(8, 30) = 0;
  EXPECT_FALSE(check_matrix(distances, true).triangular);
  EXPECT_FALSE(check_matrix(Matrix(sound(50) + Matrix(sound(50).triangularView<Eigen::Lower>())), true).triangular);
}

TEST(MatrixChecks, DetectSimilaritiesInPlaceOfDistances) {
  const Matrix similarities = 10000.0 - sound(50).array();
  EXPECT_EQ(check_matrix(similarities, true).rows_nearest_to_others, 50);
  EXPECT_EQ(check_matrix(Matrix::Ones(5, 5), true).rows_nearest_to_others, 0);
  Matrix masked = sound(50);
  masked.diagonal().setConstant(std::numeric_limits<double>::infinity());
  EXPECT_EQ(check_matrix(masked, true).rows_nearest_to_others, 0) << "an infinite diagonal excludes each model";
  EXPECT_EQ(check_matrix(masked, true).nonzero_diagonal, 0);
}

TEST(MatrixChecks, FindTheSameAnomaliesForAnyBlockSize) {
  Matrix distances = sound(100);
  distances.row(60) = distances.row(10).eval();
  distances(3, 50) = -2;
  distances(99, 9) = std::numeric_limits<double>::infinity();
  distances(4, 4) = 0.5;
  distances.row(70).setConstant(3);
  for (const Eigen::Index together : {1, 7, 64, 99}) {
    const MatrixFindings whole = check_matrix(distances, true);
    const MatrixFindings found = check_matrix(distances, true, together);
    EXPECT_EQ(found.negative, 1);
    EXPECT_EQ(found.infinite, whole.infinite);
    EXPECT_EQ(found.nonzero_diagonal, whole.nonzero_diagonal);
    EXPECT_EQ(found.rows_nearest_to_others, whole.rows_nearest_to_others);
    EXPECT_THAT(found.equal_rows, ElementsAre(Pair(60, 10)));
    EXPECT_EQ(found.constant_rows, whole.constant_rows);
    EXPECT_GT(found.asymmetric_pairs, 100);
    EXPECT_EQ(found.asymmetric_pairs, whole.asymmetric_pairs);
    EXPECT_EQ(found.largest_asymmetry, whole.largest_asymmetry);
  }
}

RC_GTEST_PROP(MatrixChecks, CountEveryAsymmetricPair, ()) {
  const auto size = *rc::gen::inRange<Eigen::Index>(1, 90);
  const Matrix distances = Matrix::NullaryExpr(size, size, [] { return *rc::gen::inRange(0, 3); });
  Eigen::Index pairs = 0;
  double largest = 0;
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (distances(i, j) != distances(j, i)) ++pairs;
      largest = std::max(largest, std::abs(distances(i, j) - distances(j, i)));
    }
  }
  const MatrixFindings found = check_matrix(distances, true, *rc::gen::inRange<Eigen::Index>(1, 100));
  RC_ASSERT(found.asymmetric_pairs == pairs);
  RC_ASSERT(found.largest_asymmetry == largest);
}

TEST(MatrixChecks, IgnoreSymmetryAndDiagonalOfQueryTargetMatrices) {
  const MatrixFindings found = check_matrix(Matrix::Random(4, 9), false);
  EXPECT_EQ(found.asymmetric_pairs, 0);
  EXPECT_EQ(found.nonzero_diagonal, 0);
}

}  // namespace
}  // namespace shapegauge
