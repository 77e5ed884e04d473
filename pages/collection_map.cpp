// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/collection_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "shapegauge/core/base/decompositions.h"

namespace shapegauge {

namespace {

/// Returns the models that are at a finite distance from another one.
std::vector<Eigen::Index> connected_models(const Eigen::MatrixXd& distances) {
  std::vector<Eigen::Index> models;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    const Eigen::Index itself = std::isfinite(distances(i, i)) ? 1 : 0;
    if (distances.row(i).array().isFinite().count() > itself) models.push_back(i);
  }
  return models;
}

/// Returns the squares of symmetric finite distances.
Eigen::MatrixXd squared_distances(const Eigen::MatrixXd& distances, const std::vector<Eigen::Index>& models) {
  Eigen::MatrixXd squares = distances(models, models);
  const double largest = squares.array().isFinite().select(squares.array(), 0.0).maxCoeff();
  squares = squares.array().isFinite().select(squares.array(), largest).matrix().eval();
  squares.diagonal().setZero();
  return (0.5 * (squares + squares.transpose())).cwiseAbs2();
}

}  // namespace

Eigen::MatrixX2d plane_embedding(const Eigen::MatrixXd& distances) {
  Eigen::MatrixX2d positions =
      Eigen::MatrixX2d::Constant(distances.rows(), 2, std::numeric_limits<double>::quiet_NaN());
  const std::vector<Eigen::Index> models = connected_models(distances);
  const auto count = std::ssize(models);
  if (count < 2) return positions;
  const Eigen::MatrixXd squares = squared_distances(distances, models);
  const Eigen::VectorXd means = squares.rowwise().mean();
  Eigen::MatrixXd products = -0.5 * ((squares.colwise() - means).rowwise() - means.transpose());
  products.array() -= 0.5 * means.mean();
  const auto solver = eigen_decomposition(products);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    Eigen::VectorXd along = solver.eigenvectors().col(count - 1 - axis);
    Eigen::Index largest = 0;
    along.cwiseAbs().maxCoeff(&largest);
    const double length = std::sqrt(std::max(0.0, solver.eigenvalues()[count - 1 - axis]));
    positions(models, axis) = along * (along[largest] < 0 ? -length : length);
  }
  return positions;
}

}  // namespace shapegauge
