// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <array>
#include <gtest/gtest.h>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/graph_inverse.h"

namespace shapegauge {
namespace {

/// A symmetric graph without loops, with eigenvalues in [-1, 1].
Eigen::MatrixXd random_graph(Eigen::Index size) {
  RandomNumbers random(1);
  Eigen::MatrixXd graph = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (random.uniform(0, 1) < 0.2) graph(i, j) = graph(j, i) = random.uniform(0, 1);
    }
  }
  const Eigen::VectorXd roots = graph.rowwise().sum().cwiseMax(1e-3).cwiseSqrt().cwiseInverse();
  return roots.asDiagonal() * graph * roots.asDiagonal();
}

class DiffusionGraphInverse : public testing::TestWithParam<double> {
 protected:
  Eigen::MatrixXd dense_ = random_graph(50);
  WalkGraph graph_ = dense_.sparseView();
  Eigen::MatrixXd system_ = Eigen::MatrixXd::Identity(50, 50) - GetParam() * dense_;
  Eigen::MatrixXd inverse_ = system_.llt().solve(Eigen::MatrixXd(Eigen::MatrixXd::Identity(50, 50)));
};

TEST_P(DiffusionGraphInverse, ColumnSolverMatchesTheDenseInverse) {
  const FloatColumns columns = ColumnSolver(graph_, GetParam()).columns(17, 20);
  EXPECT_LT((columns.cast<double>() - inverse_.middleCols(17, 20)).cwiseAbs().maxCoeff(), 2e-6 * inverse_.maxCoeff());
}

TEST_P(DiffusionGraphInverse, DiagonalSolverMatchesTheDenseInverse) {
  const std::array<Eigen::Index, 3> models{40, 0, 13};
  const Eigen::VectorXd entries = DiagonalSolver(graph_, GetParam()).entries(models);
  for (std::size_t k = 0; k < models.size(); ++k) {
    EXPECT_NEAR(entries[static_cast<Eigen::Index>(k)], inverse_(models[k], models[k]), 2e-6 * inverse_.maxCoeff());
  }
}

TEST_P(DiffusionGraphInverse, DenseInverseIsIdenticalToThatOfTheEigenLibrary) {
  EXPECT_EQ(positive_definite_inverse(system_), inverse_);
}

INSTANTIATE_TEST_SUITE_P(Damping, DiffusionGraphInverse, testing::Values(0, 0.3, 0.95));

}  // namespace
}  // namespace shapegauge
