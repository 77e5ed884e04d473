// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/search/search.h"
#include "shapegauge/retrieval/distances.h"
#include "shapegauge/retrieval/nearest_models.h"

/// Distances within an index, by rows.

namespace shapegauge {

/// Returns per term the distance by which the method compares signatures.
std::vector<NamedDistance> distances_of(const SearchMethod& method);

/// Computes the sum over the models in the index. Parallel.
CollectionSum sum_of(const SearchMethod& method, const ShapeIndex& index, const RunControl& control);

/// Computes per term the distances from a signature to all models. `member` is its index if it is one of them,
/// otherwise -1. Parallel. Throws ArgumentError for signatures outside the distance's domain.
std::vector<Eigen::VectorXd> term_distances(const std::vector<NamedDistance>& distances, const ShapeIndex& index,
                                            std::span<const Eigen::RowVectorXf> signatures, Eigen::Index member);

/// Finds the `count` nearest models of each model by the sum. Parallel.
NearestModels nearest_in(const SearchMethod& method, const ShapeIndex& index, int count, const RunControl& control);

/// Writes the index to its file, or adds a note with the reason if that fails.
void write_index(const OpenIndex& index, std::vector<std::string>& notes);

}  // namespace shapegauge
