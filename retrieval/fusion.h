#pragma once

#include <span>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// What a distance matrix is divided by before it is added to others: a number over the distances between different
/// models.
enum class DistanceScale { none, median, mean };

/// The sum of distance matrices of the same models, each divided by its scale and multiplied by its weight. A distance
/// that is infinite in a matrix of positive weight is infinite in the sum; scales are over the finite ones. Sums of
/// finite distances are finite: too large ones become the largest number. Throws ArgumentError where there are
/// no matrices, they differ in size or are not square, weights are not as many, a weight is negative or not finite, a
/// distance is negative or not a number, all weights are 0, or a scale is 0.
DistanceMatrix sum_of_distances(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                DistanceScale scale = DistanceScale::median);

/// How ranks are turned into a score.
enum class RankScore {
  reciprocal,  ///< 1 / (60 + rank) (Cormack, Clarke, Buettcher 2009): what is ranked first anywhere counts most
  borda,       ///< the number of models ranked behind: all ranks count alike
};

/// Fusion of rankings: each model's row of each matrix is ranked (the model itself left out; of equal distances the
/// lesser index first), and the ranks' scores are summed by weight. The distance is 1 minus the mean of the scores of
/// (i, j) and (j, i), over the score of a model that all rank first: symmetric, from 0 to below 1, zero on the
/// diagonal. It only depends on the orders. Models at an infinite distance have no rank and score 0; those that no
/// matrix ranks, in neither row, stay at an infinite distance. Throws as sum_of_distances().
DistanceMatrix fusion_of_ranks(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                               RankScore score = RankScore::reciprocal);

}  // namespace shapegauge
