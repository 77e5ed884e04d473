// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/words.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

/// Normalisation of a distance matrix before it is added to others. Search indices contain its number.
enum class DistanceScale {
  none,
  median,  ///< median over pairs of different models
  mean,    ///< mean over pairs of different models
  /// Local scaling: divides each distance by sqrt(s_i s_j), where s_i is the mean distance of i to its ten nearest
  /// (Zelnik-Manor and Perona 2004). Models at distance 0 are duplicates and not among the ten. s is at least a
  /// hundredth of its median, which limits the effect of groups of almost equal models.
  local,
  ranks,         ///< log(1 + mutual rank) of locally scaled distances (log_mutual_ranks())
  local_spread,  ///< older name of `ranks`
};

template <>
inline constexpr std::array<std::string_view, 6> words_of<DistanceScale>{"none",  "median", "mean",
                                                                         "local", "ranks",  "local_spread"};

/// Returns true if distances become mutual ranks.
constexpr bool uses_ranks(DistanceScale scale) {
  return scale == DistanceScale::ranks || scale == DistanceScale::local_spread;
}

/// Returns true if distances are divided by local scales.
constexpr bool uses_local_scales(DistanceScale scale) { return scale == DistanceScale::local || uses_ranks(scale); }

/// Unsupervised weighting of a sum, in addition to the given weights.
enum class SumWeights {
  given,      ///< given weights only
  agreement,  ///< agreement of a matrix's neighbours with those of other matrices, and their cohesion
};

template <>
inline constexpr std::array<std::string_view, 2> words_of<SumWeights>{"given", "agreement"};

/// Options of a sum of distances.
struct SumOptions {
  DistanceScale scale = DistanceScale::median;
  SumWeights weights = SumWeights::given;
};

/// Parameters of SumOptions.
inline constexpr std::array sum_table = {
    option_of<&SumOptions::scale>(
        "scale",
        "With sum: normalisation of each signature's distances. median, mean: divided by that of all pairs of models; "
        "local: divided by the two models' mean distances to their ten nearest neighbours; ranks: as local, then "
        "replaced by log(1 + mean of the two models' ranks among each other's neighbours); local_spread: as ranks."),
    option_of<&SumOptions::weights>("weights",
                                    "With sum: factor of the given weights. given: 1; agreement: estimated from how "
                                    "far neighbourhoods agree between signatures and cohere within one."),
};

/// Computes the weighted sum of normalised distance matrices of the same models. A distance that is infinite in a
/// matrix of positive weight is infinite in the sum; scales use the finite distances. Sums of finite distances are
/// finite, limited to the largest number.
///
/// Throws ArgumentError if there are no matrices, they differ in size or are not square; for a wrong number of weights;
/// if a weight or distance is negative or not a number, a weight is infinite, or all weights are 0; and if a median or
/// mean is 0.
DistanceMatrix sum_of_distances(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                DistanceScale scale = SumOptions{}.scale);

/// Throws ArgumentError if there are no terms, for a wrong number of weights, if a weight is negative or not finite, or
/// all are 0.
void check_sum_weights(std::size_t terms, std::span<const double> weights);

/// Returns the divisor of distances with DistanceScale::median (for an even count, the greater of the middle two) or
/// mean, over finite distances between different models. 1 if there are none, and with DistanceScale::none.
double distance_unit(const DistanceMatrix& matrix, DistanceScale scale);

/// Computes the weights of a sum: each given weight times (agreement x cohesion)^4 of its matrix. Both are
/// means over those k of neighbour_counts() that are less than the number of other models.
/// - agreement: mean share of a model's k nearest that are also among its k nearest by another matrix, over the models
///   and the other matrices, the latter by their given weights.
/// - cohesion: mean Jaccard index of the set of a model and its k nearest and the same set of each of those.
///
/// Matrices that find the same groups agree; a matrix that finds groups is cohesive. A model's nearest are those
/// strictly nearer than the next one: equal distances and, up to rounding, the order of models have no effect. If all
/// factors are 0, or only one weight is positive, returns the given weights. Throws as sum_of_distances() does.
std::vector<double> sum_weights(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                SumWeights kind);

/// Computes the weights with SumWeights::agreement from the nearest models by each matrix: nearest_for_weights() of
/// them, if there are as many. They may be missing for matrices of weight 0.
std::vector<double> sum_weights(std::span<const NearestModels> nearest, std::span<const double> weights);

/// Returns the number of nearest models that the weights depend on.
int nearest_for_weights();

/// Two matrices that find different groups.
struct Disagreement {
  std::size_t first = 0;
  std::size_t second = 0;
  double agreement = 0;
  double cohesion = 0;  ///< the smaller of both
};

/// Finds the two matrices of positive weight whose agreement is smallest, relative to the smaller of their cohesions
/// (sum_weights()). Nothing unless this ratio is below a half: the matrices then group the models differently. Throws
/// as sum_of_distances() does.
std::optional<Disagreement> find_disagreement(std::span<const DistanceMatrix> matrices,
                                              std::span<const double> weights);

/// Score of a rank.
enum class RankScore {
  reciprocal,  ///< 1 / (60 + rank) (Cormack, Clarke, Buettcher 2009): emphasises first ranks
  borda,       ///< number of models ranked behind: all ranks count equally
};

template <>
inline constexpr std::array<std::string_view, 2> words_of<RankScore>{"reciprocal", "borda"};

/// Options of fusion_of_ranks().
struct RankFusionOptions {
  RankScore score = RankScore::reciprocal;
};

/// Parameters of RankFusionOptions.
inline constexpr std::array rank_fusion_table = {
    option_of<&RankFusionOptions::score>(
        "score",
        "With fuse_ranks: score of a rank. reciprocal: 1 / (60 + rank), which favours first ranks; borda: linear in "
        "the rank."),
};

/// Fuses rankings: ranks each model's row of each matrix (without the model itself; ties: smaller index first) and sums
/// the ranks' scores by weight. The distance is 1 minus the mean of the scores of (i, j) and (j, i), divided by the
/// score of a model that all rank first. The result is symmetric, in [0, 1), zero on the diagonal, and depends on
/// orders only. Models at an infinite distance are unranked and score 0; pairs unranked in both rows of all matrices
/// stay at an infinite distance. Throws as sum_of_distances() does.
DistanceMatrix fusion_of_ranks(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                               RankScore score = RankFusionOptions{}.score);

}  // namespace shapegauge
