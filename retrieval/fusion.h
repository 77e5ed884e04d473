#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

/// What a distance matrix is divided by before it is added to others.
enum class DistanceScale {
  none,
  median,  ///< over the distances between different models
  mean,    ///< the same
  /// Each distance by sqrt(s_i s_j), s_i being the mean distance of i to its ten nearest (Zelnik-Manor and Perona
  /// 2004). Models at distance 0 are doubles and do not count among the ten. s is at least a hundredth of its median,
  /// so that a group of almost equal models does not outweigh the other matrices.
  local,
};

/// The sum of distance matrices of the same models, each divided by its scale and multiplied by its weight. A distance
/// that is infinite in a matrix of positive weight is infinite in the sum; scales are over the finite ones. Sums of
/// finite distances are finite: too large ones become the largest number. Throws ArgumentError where there are
/// no matrices, they differ in size or are not square, weights are not as many, a weight is negative or not finite, a
/// distance is negative or not a number, all weights are 0, or a median or mean is 0.
DistanceMatrix sum_of_distances(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                DistanceScale scale = DistanceScale::median);

/// Throws ArgumentError where there are no terms, weights are not as many, a weight is negative or not finite, or all
/// are 0.
void check_sum_weights(std::size_t terms, std::span<const double> weights);

/// What distances are divided by with DistanceScale::median (of an even number, the greater of the middle two) or mean:
/// that of the finite ones between different models. 1 where there are none, and with DistanceScale::none.
double distance_unit(const DistanceMatrix& matrix, DistanceScale scale);

/// What the weights of a sum follow from, besides those that are given. None of it knows classes.
enum class SumWeights {
  given,      ///< nothing else
  agreement,  ///< the neighbours that a matrix has in common with the others, and that neighbours have in common
};

/// The weights of a sum, each a given one times the cube of (agreement x cohesion) of the matrix, each the mean over
/// the k of neighbour_counts() that are less than the number of others:
/// - agreement: the mean share of a model's k nearest that are among its k nearest by another matrix, over the models
///   and the other matrices, the latter by their given weights.
/// - cohesion: the mean Jaccard index of the set of a model and its k nearest and the same set of each of those.
/// Two matrices that see the same groups agree; in one that sees groups at all, neighbours have the same neighbours.
/// Nearest are those nearer than the next one, so equal distances do not matter, nor, up to rounding, the order of
/// models. Where all factors are 0, or only one weight is positive, the weights are as given. Throws as
/// sum_of_distances().
std::vector<double> sum_weights(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                SumWeights kind);

/// The same with SumWeights::agreement from the nearest models by each matrix, nearest_for_weights() of them where
/// there are as many; of matrices whose weight is 0 they may be absent.
std::vector<double> sum_weights(std::span<const NearestModels> nearest, std::span<const double> weights);

/// How many nearest models these weights depend on.
int nearest_for_weights();

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
