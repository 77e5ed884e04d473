// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/search/search.h"
#include "shapegauge/retrieval/distances.h"
#include "shapegauge/retrieval/nearest_models.h"

/// Distances to the models of a search index, computed row by row.

namespace shapegauge {

/// Returns, for each term of a method, the distance that compares its signatures.
std::vector<NamedDistance> distances_of(const SearchMethod& method);

/// Computes the collection statistics of the method's sum of distances over the models of the index. Runs in parallel.
CollectionSum sum_of(const SearchMethod& method, const ShapeIndex& index, const RunControl& control);

/// Computes, for each term of the method, the distances from a query to all models of the index. `signatures` has the
/// query's signature for each term. `member` is the index of the query if it is one of the models, otherwise -1. Runs
/// in parallel. Throws ArgumentError for signatures outside the distance's domain.
std::vector<Eigen::VectorXd> term_distances(const std::vector<NamedDistance>& distances, const ShapeIndex& index,
                                            std::span<const Eigen::RowVectorXf> signatures, Eigen::Index member);

/// Finds the `count` nearest models of each model by the method's sum of distances. Runs in parallel.
NearestModels nearest_in(const SearchMethod& method, const ShapeIndex& index, int count, const RunControl& control);

/// Writes an index to its file. If that fails, adds the reason to `notes`.
void write_index(const OpenIndex& index, std::vector<std::string>& notes);

}  // namespace shapegauge
