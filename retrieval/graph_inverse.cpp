// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/graph_inverse.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

namespace {

/// Adds a row of the graph times the block to the sum.
void add_product(const FloatWalkGraph& graph, Eigen::Index row, const FloatColumns& block, std::vector<float>& sum) {
  const auto count = static_cast<Eigen::Index>(sum.size());
  for (FloatWalkGraph::InnerIterator entry(graph, row); entry; ++entry) {
    const float* const values = block.data() + entry.col() * count;
    for (Eigen::Index k = 0; k < count; ++k) sum[static_cast<std::size_t>(k)] += entry.value() * values[k];
  }
}

/// Returns columns of the identity.
FloatColumns unit_columns(Eigen::Index size, std::span<const Eigen::Index> models) {
  FloatColumns columns = FloatColumns::Zero(size, std::ssize(models));
  for (std::size_t k = 0; k < models.size(); ++k) columns(models[k], static_cast<Eigen::Index>(k)) = 1;
  return columns;
}

/// Returns the decay of the coefficients of 1 / (1 - damping x) in Chebyshev polynomials.
double series_rate(double damping) { return damping / (1 + std::sqrt(1 - damping * damping)); }

/// Replaces the lower triangle of a small matrix by that of its Cholesky factor, column by column. Returns false, and
/// stops, if the matrix is not positive definite.
bool factorise_columns(Eigen::Ref<Eigen::MatrixXd> matrix) {
  const Eigen::Index size = matrix.rows();
  for (Eigen::Index k = 0; k < size; ++k) {
    const auto before = matrix.row(k).head(k);
    auto below = matrix.col(k).tail(size - k - 1);
    const double squared = matrix(k, k) - before.squaredNorm();
    if (squared <= 0) return false;
    matrix(k, k) = std::sqrt(squared);
    below.noalias() -= matrix.bottomLeftCorner(size - k - 1, k) * before.transpose();
    below /= matrix(k, k);
  }
  return true;
}

/// Replaces the lower triangle by that of the Cholesky factor, in the blocks of Eigen's LLT. Can be interrupted between
/// blocks.
void factorise(Eigen::MatrixXd& matrix) {
  const Eigen::Index size = matrix.rows();
  if (size < 32) {
    factorise_columns(matrix);
    return;
  }
  const Eigen::Index block = std::clamp<Eigen::Index>(size / 8 / 16 * 16, 8, 128);
  for (Eigen::Index k = 0; k < size; k += block) {
    check_interruption();
    const Eigen::Index width = std::min(block, size - k);
    const Eigen::Index rest = size - k - width;
    auto corner = matrix.block(k, k, width, width);
    if (!factorise_columns(corner) || rest == 0) return;
    auto below = matrix.block(k + width, k, rest, width);
    corner.adjoint().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(below);
    matrix.block(k + width, k + width, rest, rest).selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
  }
}

}  // namespace

ColumnSolver::ColumnSolver(const WalkGraph& graph, double damping)
    : graph_((damping * graph).cast<float>()), squared_damping_(damping * damping) {
  constexpr double tolerance = 1e-6;
  steps_ = damping > 0 ? static_cast<int>(std::ceil(std::log(2 / tolerance) / -std::log(series_rate(damping)))) : 0;
}

FloatColumns ColumnSolver::columns(Eigen::Index first, Eigen::Index count) const {
  FloatColumns before = FloatColumns::Zero(graph_.rows(), count);
  FloatColumns now = FloatColumns::Zero(graph_.rows(), count);
  now.middleRows(first, count).setIdentity();
  double weight = 1 / (1 - squared_damping_ / 2);
  for (int step = 0; step < steps_; ++step) {
    advance(first, static_cast<float>(weight), now, before);
    now.swap(before);
    weight = 1 / (1 - squared_damping_ * weight / 4);
  }
  return now;
}

void ColumnSolver::advance(Eigen::Index first, float weight, const FloatColumns& now, FloatColumns& before) const {
  const Eigen::Index count = now.cols();
  std::vector<float> sum(static_cast<std::size_t>(count));
  for (Eigen::Index row = 0; row < graph_.rows(); ++row) {
    std::ranges::fill(sum, 0.0F);
    if (row >= first && row < first + count) sum[static_cast<std::size_t>(row - first)] = 1;
    add_product(graph_, row, now, sum);
    float* const values = before.data() + row * count;
    for (Eigen::Index k = 0; k < count; ++k) values[k] += weight * (sum[static_cast<std::size_t>(k)] - values[k]);
  }
}

DiagonalSolver::DiagonalSolver(const WalkGraph& graph, double damping)
    : graph_(graph.cast<float>()), rate_(series_rate(damping)), root_(std::sqrt(1 - damping * damping)) {
  constexpr double tolerance = 1e-6;
  const double terms = damping > 0 ? std::log(tolerance * root_ * (1 - rate_) / 2) / std::log(rate_) : 0;
  steps_ = static_cast<int>(std::ceil(terms / 2));
}

Eigen::VectorXd DiagonalSolver::entries(std::span<const Eigen::Index> models) const {
  const auto count = std::ssize(models);
  FloatColumns now = unit_columns(graph_.rows(), models);
  FloatColumns before = FloatColumns::Zero(graph_.rows(), count);
  Eigen::ArrayXd sums = Eigen::ArrayXd::Constant(count, 1 / root_);
  Eigen::ArrayXd squares(count);
  Eigen::ArrayXd products(count);
  double coefficient = 2 / root_;
  for (int step = 0; step < steps_; ++step) {
    advance(step > 0 ? 2.0F : 1.0F, now, before, squares, products);
    if (step > 0) sums += coefficient * (2 * squares - 1);
    coefficient *= rate_;
    if (step > 0) sums += coefficient * 2 * products;  // no model is its own neighbour: T_1 has a diagonal of zeros
    coefficient *= rate_;
    now.swap(before);
  }
  return sums;
}

void DiagonalSolver::advance(float factor, const FloatColumns& now, FloatColumns& before, Eigen::ArrayXd& squares,
                             Eigen::ArrayXd& products) const {
  const Eigen::Index count = now.cols();
  squares.setZero();
  products.setZero();
  std::vector<float> sum(static_cast<std::size_t>(count));
  for (Eigen::Index row = 0; row < graph_.rows(); ++row) {
    std::ranges::fill(sum, 0.0F);
    add_product(graph_, row, now, sum);
    float* const next = before.data() + row * count;
    const float* const values = now.data() + row * count;
    for (Eigen::Index k = 0; k < count; ++k) {
      next[k] = factor * sum[static_cast<std::size_t>(k)] - next[k];
      squares[k] += double{values[k]} * values[k];
      products[k] += double{values[k]} * next[k];
    }
  }
}

Eigen::MatrixXd positive_definite_inverse(Eigen::MatrixXd matrix) {
  // A multiple of the column block of Eigen's kernels, for the same bits as in the whole.
  constexpr Eigen::Index columns_together = 64;
  const Eigen::Index size = matrix.rows();
  factorise(matrix);
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(size, size);
  parallel_for(Eigen::Index{0}, (size + columns_together - 1) / columns_together, [&](Eigen::Index part) {
    const Eigen::Index first = part * columns_together;
    auto columns = inverse.middleCols(first, std::min(columns_together, size - first));
    matrix.triangularView<Eigen::Lower>().solveInPlace(columns);
    matrix.triangularView<Eigen::Lower>().transpose().solveInPlace(columns);
  });
  return inverse;
}

}  // namespace shapegauge
