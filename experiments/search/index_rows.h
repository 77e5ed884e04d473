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

/// Returns the distance between signatures for each term of a search method (SearchMethod::terms).
std::vector<NamedDistance> distances_of(const SearchMethod& method);

/// Computes the weights and the normalisation of the terms in the method's weighted sum of distances, from the
/// distances between all models of the index. Runs in parallel.
CollectionSum sum_of(const SearchMethod& method, const ShapeIndex& index, const RunControl& control);

/// Computes the distances from a query to all models of the index, one vector per entry of `distances` (a term of the
/// sum). `signatures` has the query's signature for each term. `member` is the index of the query if it is one of the
/// models, otherwise -1. Runs in parallel. Throws ArgumentError for signatures outside the distance's domain.
std::vector<Eigen::VectorXd> term_distances(const std::vector<NamedDistance>& distances, const ShapeIndex& index,
                                            std::span<const Eigen::RowVectorXf> signatures, Eigen::Index member);

/// Finds the `count` nearest other models of each model of the index by the method's weighted sum of distances. Runs in
/// parallel.
NearestModels nearest_models_in_index(const SearchMethod& method, const ShapeIndex& index, int count,
                                      const RunControl& control);

/// Writes an index to its file. If that fails, adds the reason to `notes`.
void write_index(const OpenIndex& index, std::vector<std::string>& notes);

}  // namespace shapegauge
