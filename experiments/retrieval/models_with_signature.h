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
  /// Makes the subset of `all` models without the failed ones; `without` has their indices, from 0 to all - 1.
  ModelsWithSignature(const std::vector<ModelFailure>& without, std::size_t all);

  [[nodiscard]] bool are_all() const { return places_.size() == is_in_.size(); }
  [[nodiscard]] const std::vector<Eigen::Index>& places() const { return places_; }

  /// Expands the distances between models with a signature (`between`) to all models: infinite for models without one,
  /// and 0 on the diagonal.
  [[nodiscard]] DistanceMatrix spread(DistanceMatrix between) const;

  /// Makes the distances from and to models without a signature infinite, and 0 on the diagonal, in a block of rows of
  /// the distance matrix of all models. `first` is the index of the first row of the block.
  void set_infinite(DistanceMatrix& rows, Eigen::Index first) const;

  /// Returns the signatures of all models (one per row) in which models without one have the row of the first model
  /// that has one, so that all distances are defined.
  [[nodiscard]] Signatures with_stand_ins(const Signatures& rows) const;

 private:
  std::vector<bool> is_in_;
  std::vector<Eigen::Index> places_;
};

}  // namespace shapegauge
