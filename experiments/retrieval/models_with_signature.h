// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Subset of the models of a run that have the signature of a method. Models that the method cannot process have no
/// signature and are infinitely far from all others.
class ModelsWithSignature {
 public:
  /// Makes the subset of the models 0 to all - 1 that leaves out those in `without` (ModelFailure::model).
  ModelsWithSignature(const std::vector<ModelFailure>& without, std::size_t all);

  /// Returns true if every model has a signature.
  [[nodiscard]] bool has_all_models() const { return indices_.size() == has_signature_.size(); }
  /// Returns the indices of the models with a signature, in ascending order.
  [[nodiscard]] const std::vector<Eigen::Index>& indices() const { return indices_; }

  /// Expands the distances between models with a signature (`between`) to all models: infinite for models without one,
  /// and 0 on the diagonal.
  [[nodiscard]] DistanceMatrix spread(DistanceMatrix between) const;

  /// Makes the distances from and to models without a signature infinite, and 0 on the diagonal, in a block of rows of
  /// the distance matrix of all models. `first` is the index of the first row of the block.
  void set_infinite(DistanceMatrix& rows, Eigen::Index first) const;

  /// Returns `rows`, the signatures of all models, with the row of each model without a signature replaced by that of
  /// the first model with one, so that all distances are defined.
  [[nodiscard]] Signatures with_placeholder_rows(const Signatures& rows) const;

 private:
  std::vector<bool> has_signature_;    ///< per model: true if the model has a signature
  std::vector<Eigen::Index> indices_;  ///< indices of the models with a signature
};

}  // namespace shapegauge
