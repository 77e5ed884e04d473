// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/retrieval/models_with_signature.h"

#include <limits>

namespace shapegauge {

ModelsWithSignature::ModelsWithSignature(const std::vector<ModelFailure>& without, std::size_t all)
    : has_signature_(all, true) {
  for (const ModelFailure& failure : without) has_signature_[failure.model] = false;
  for (std::size_t i = 0; i < all; ++i) {
    if (has_signature_[i]) indices_.push_back(static_cast<Eigen::Index>(i));
  }
}

DistanceMatrix ModelsWithSignature::spread(DistanceMatrix between) const {
  if (has_all_models()) return between;
  const auto all = std::ssize(has_signature_);
  DistanceMatrix distances = DistanceMatrix::Constant(all, all, std::numeric_limits<double>::infinity());
  distances(indices_, indices_) = between;
  distances.diagonal().setZero();
  return distances;
}

void ModelsWithSignature::set_infinite(DistanceMatrix& rows, Eigen::Index first) const {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index j = 0; j < rows.cols(); ++j) {
      if (has_signature_[static_cast<std::size_t>(first + i)] && has_signature_[static_cast<std::size_t>(j)]) continue;
      rows(i, j) = first + i == j ? 0 : std::numeric_limits<double>::infinity();
    }
  }
}

Signatures ModelsWithSignature::with_placeholder_rows(const Signatures& rows) const {
  Signatures filled = rows;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    if (!has_signature_[static_cast<std::size_t>(i)]) filled.row(i) = rows.row(indices_.front());
  }
  return filled;
}

}  // namespace shapegauge
