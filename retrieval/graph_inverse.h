// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>

/// Inverse of I - damping graph, for the symmetric graph of a random walk with eigenvalues in [-1, 1]: single columns,
/// entries of the diagonal, or the whole.

namespace shapegauge {

/// Normalised symmetric affinity matrix of a random walk (diffusion_graph()): one row and column per model.
using WalkGraph = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using FloatWalkGraph = Eigen::SparseMatrix<float, Eigen::RowMajor>;  ///< WalkGraph in single precision
/// Columns of a matrix for a few models: one row per model of the graph, one column per selected model.
using FloatColumns = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Computes columns of (I - damping graph)^-1 by the Chebyshev semi-iteration (Golub and Varga 1961). The graph's
/// eigenvalues are in [-1, 1], which determines the number of steps for a tolerance of 1e-6. Single precision is finer
/// than this tolerance.
class ColumnSolver {
 public:
  ColumnSolver(const WalkGraph& graph, double damping);  ///< damping from 0 to below 1

  /// Returns `count` columns of the inverse from column `first` on.
  [[nodiscard]] FloatColumns columns(Eigen::Index first, Eigen::Index count) const;

 private:
  /// Computes an iteration for the columns from index `first` on: before += weight (damping graph now + columns of the
  /// identity - before).
  void advance(Eigen::Index first, float weight, const FloatColumns& now, FloatColumns& before) const;

  FloatWalkGraph graph_;    ///< damping times the graph
  double squared_damping_;  ///< damping^2
  int steps_;               ///< number of Chebyshev iterations in each call of columns()
};

/// Computes entries of the diagonal of (I - damping graph)^-1 as a series of Chebyshev polynomials T_m of the graph.
/// Columns of T_m give the diagonals of T_2m and T_2m+1, since T_2m = 2 T_m^2 - 1 and T_2m+1 = 2 T_m T_m+1 - T_1
/// (Weisse, Wellein, Alvermann, Fehske 2006); half of the series suffices.
class DiagonalSolver {
 public:
  DiagonalSolver(const WalkGraph& graph, double damping);  ///< damping from 0 to below 1

  /// Returns the diagonal entries of the models with these indices, in their order.
  [[nodiscard]] Eigen::VectorXd entries(std::span<const Eigen::Index> models) const;

 private:
  /// Sets `before` to factor graph now - before. Also computes the squared norm of each column of `now`, and the
  /// dot product of each column of `now` with the same column of the new `before`.
  void advance(float factor, const FloatColumns& now, FloatColumns& before, Eigen::ArrayXd& squares,
               Eigen::ArrayXd& products) const;

  FloatWalkGraph graph_;  ///< graph in single precision
  double rate_;           ///< ratio of consecutive coefficients of the Chebyshev series
  double root_;           ///< sqrt(1 - damping^2)
  int steps_;             ///< number of multiplications by the graph in each call of entries()
};

/// Inverts a symmetric positive definite matrix by its Cholesky factorisation, in parallel where possible. The result
/// has the same bits as Eigen's matrix.llt().solve(identity), on any number of threads. Throws Interrupted if the user
/// interrupts it.
Eigen::MatrixXd positive_definite_inverse(Eigen::MatrixXd matrix);

}  // namespace shapegauge
