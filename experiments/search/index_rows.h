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

/// By term, the distance that the method compares its signatures by.
std::vector<NamedDistance> distances_of(const SearchMethod& method);

/// The sum over the models whose tables the index has. `before`: an earlier index by the same method, or nullptr;
/// models of the same id and contents need no new rows then, and the result is the same. In parallel.
CollectionSum sum_of(const SearchMethod& method, const ShapeIndex& index, const RunControl& control,
                     const ShapeIndex* before = nullptr);

/// By term, the distances from a signature to all models. `member`: its index where it is one of them, else -1. In
/// parallel. Throws ArgumentError for signatures that the distance does not take.
std::vector<Eigen::VectorXd> term_distances(const std::vector<NamedDistance>& distances, const ShapeIndex& index,
                                            std::span<const Eigen::RowVectorXf> signatures, Eigen::Index member);

/// The nearest models of each by the sum, so many. In parallel.
NearestModels nearest_in(const SearchMethod& method, const ShapeIndex& index, int count, const RunControl& control);

/// Writes the index to its file, or adds a note that says why it cannot.
void write_index(const OpenIndex& index, std::vector<std::string>& notes);

}  // namespace shapegauge
