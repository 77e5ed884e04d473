#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/registry.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Re-ranking: distances between the models of a set, improved by what the distances say of the whole set. None of it
/// knows classes. Every function gives the same bytes on any number of threads, and permuting the models permutes the
/// result (up to rounding, and to equal distances, of which the lesser index counts as nearer).
///
/// Models at an infinite distance are no neighbours. An infinite distance stays infinite unless neighbours join the two
/// models: it then counts as the largest finite distance of the matrix. So a model without neighbours keeps infinite
/// distances to all others, and the others get the distances that they have without it. Finite distances give finite
/// ones, however large they are. The diagonal plays no part.
namespace shapegauge {

/// The word for neighbour_counts() of no numbers.
inline constexpr std::array<std::string_view, 1> automatic_neighbours{"auto"};

/// The numbers of neighbours that a re-ranking of so many models takes the mean over, ascending. Of an empty list
/// ("auto") they are 4, 5, 7, 10, 14 and 20, so that none need be guessed.
std::vector<int> neighbour_counts(const IntegerList& neighbours);

/// A way to re-rank that configurations and commands know by name. Functions throw InputError for settings out of
/// range.
struct RerankMethod {
  std::string_view name;
  std::string_view description;  ///< one sentence
  std::span<const Parameter> parameters;
  DistanceMatrix (*rerank)(const DistanceMatrix&, const ParameterValues&) = nullptr;
};

/// All ways to re-rank: one file each and one line in rerank.cpp, then those that were added.
Registry<RerankMethod>& rerank_methods();

}  // namespace shapegauge
