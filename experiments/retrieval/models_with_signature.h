// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Models of a run that have a signature, by position. A model that a method cannot process has none, and is infinitely
/// far from all others.
class ModelsWithSignature {
 public:
  /// `without` are failures of models, by position among `all`.
  ModelsWithSignature(const std::vector<ModelFailure>& without, std::size_t all);

  [[nodiscard]] bool are_all() const { return places_.size() == is_in_.size(); }
  [[nodiscard]] const std::vector<Eigen::Index>& places() const { return places_; }

  /// Returns the distances between all models, given those between the ones with the signature.
  [[nodiscard]] DistanceMatrix spread(DistanceMatrix between) const;

  /// Makes the distances to and from models without the signature infinite; the first row is that of model `first`.
  void set_infinite(DistanceMatrix& rows, Eigen::Index first) const;

  /// Returns the signatures with the row of another model for models without one, so that all have distances.
  [[nodiscard]] Signatures with_stand_ins(const Signatures& rows) const;

 private:
  std::vector<bool> is_in_;
  std::vector<Eigen::Index> places_;
};

}  // namespace shapegauge
