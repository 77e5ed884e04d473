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

/// Normalisation of a distance matrix before it is added to others. Files of search indices store the enumerator's
/// number.
enum class DistanceScale {
  none,    ///< distances stay as they are
  median,  ///< divides distances by their median over pairs of different models
  mean,    ///< divides distances by their mean over pairs of different models
  /// Local scaling: divides each distance by sqrt(s_i s_j), where s_i is the mean distance of i to its ten nearest
  /// (Zelnik-Manor and Perona 2004). Models at distance 0 are duplicates and not among the ten. s is at least a
  /// hundredth of its median, which limits the effect of groups of almost equal models.
  local,
  ranks,         ///< replaces locally scaled distances by log(1 + mutual rank) (log_mutual_ranks())
  local_spread,  ///< same as `ranks`, in configurations of older versions
};

template <>
inline constexpr std::array<std::string_view, 6> words_of<DistanceScale>{"none",  "median", "mean",
                                                                         "local", "ranks",  "local_spread"};

/// Returns true for a scale that replaces distances by logarithms of mutual ranks.
constexpr bool uses_ranks(DistanceScale scale) {
  return scale == DistanceScale::ranks || scale == DistanceScale::local_spread;
}

/// Returns true for a scale that divides distances by local scales, possibly before ranking.
constexpr bool uses_local_scales(DistanceScale scale) { return scale == DistanceScale::local || uses_ranks(scale); }

/// Weighting of the distance matrices in a sum, without supervision.
enum class SumWeights {
  given,  ///< weights specified by the caller, unchanged
  /// Specified weights times factors: large for a matrix whose nearest models agree with those of the other matrices
  /// and form groups (sum_weights()).
  agreement,
};

template <>
inline constexpr std::array<std::string_view, 2> words_of<SumWeights>{"given", "agreement"};

/// Options of a weighted sum of distance matrices.
struct SumOptions {
  DistanceScale scale = DistanceScale::median;  ///< normalisation of each matrix
  SumWeights weights = SumWeights::given;       ///< weighting of the matrices
};

/// Names, bounds and help texts of the parameters in SumOptions (option_parameters.h).
inline constexpr std::array sum_table = {
    option_of<&SumOptions::scale>(
        "scale",
        "With sum: normalisation of each signature's distances. none: unchanged; median, mean: divided by their median "
        "or mean; local: divided by the geometric mean of the two models' mean distances to their ten nearest models; "
        "ranks: log(1 + mean rank of the two models in each other's lists, sorted by `local` distances); local_spread: "
        "older name of ranks."),
    option_of<&SumOptions::weights>("weights",
                                    "With sum: weighting of the signatures. given: by `weight`; agreement: by `weight` "
                                    "times an unsupervised factor, larger if nearest neighbours form clusters and "
                                    "agree with those of the other signatures."),
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

/// Validates the weights of a sum of `terms` distance matrices. Throws ArgumentError if there are no terms, for a wrong
/// number of weights, if a weight is negative or not finite, or if all weights are 0.
void check_sum_weights(std::size_t terms, std::span<const double> weights);

/// Returns the divisor of distances with DistanceScale::median (for an even count, the greater of the middle two) or
/// mean, over finite distances between different models. 1 if there are none, and with DistanceScale::none.
double distance_unit(const DistanceMatrix& matrix, DistanceScale scale);

/// Computes the weights of a sum: the given weights or, with SumWeights::agreement, each given weight times
/// (agreement x cohesion)^4 of its matrix. Agreement and cohesion are means over those k of 4, 5, 7, 10, 14 and 20 that
/// are less than the number of other models.
/// - agreement: mean share of a model's k nearest that are also among its k nearest by another matrix, over the models
///   and the other matrices, weighted by the given weights of these matrices.
/// - cohesion: mean Jaccard index of the set of a model and its k nearest and the corresponding set of each of the k.
///
/// Matrices that find the same groups agree; a matrix that finds groups is cohesive. A model's nearest are those
/// strictly nearer than the next one: equal distances and, up to rounding, the order of models have no effect. If all
/// factors are 0, or only one weight is positive, returns the given weights. Throws as sum_of_distances() does.
std::vector<double> sum_weights(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                SumWeights kind);

/// Computes the weights of a sum with SumWeights::agreement from the given `weights`. `nearest` holds, for each matrix,
/// the nearest_for_weights() nearest models of each model, or all if there are fewer. It may be empty for a matrix of
/// weight 0.
std::vector<double> sum_weights(std::span<const NearestModels> nearest, std::span<const double> weights);

/// Returns the number of nearest models per model that the weights with SumWeights::agreement depend on.
int nearest_for_weights();

/// Two distance matrices of the same models whose nearest neighbours agree little.
struct Disagreement {
  std::size_t first = 0;   ///< index of one matrix
  std::size_t second = 0;  ///< index of the other matrix
  double agreement = 0;  ///< mean share of a model's nearest that both matrices have in common, 0 to 1 (sum_weights())
  double cohesion = 0;   ///< how well nearest models form groups in the less cohesive matrix, 0 to 1 (sum_weights())
};

/// Finds the two matrices of positive weight whose agreement is smallest, relative to the smaller of their cohesions
/// (sum_weights()). Returns nothing unless this ratio is below a half: the matrices then group the models differently.
/// Throws as sum_of_distances() does.
std::optional<Disagreement> find_disagreement(std::span<const DistanceMatrix> matrices,
                                              std::span<const double> weights);

/// Score of a model by its rank in a row of a distance matrix.
enum class RankScore {
  reciprocal,  ///< 1 / (60 + rank) (Cormack, Clarke, Buettcher 2009): emphasises the first ranks
  borda,       ///< number of models minus rank: decreases linearly
};

template <>
inline constexpr std::array<std::string_view, 2> words_of<RankScore>{"reciprocal", "borda"};

/// Options of fusion_of_ranks().
struct RankFusionOptions {
  RankScore score = RankScore::reciprocal;  ///< score of a rank, summed over the matrices
};

/// Names, bounds and help texts of the parameters in RankFusionOptions (option_parameters.h).
inline constexpr std::array rank_fusion_table = {
    option_of<&RankFusionOptions::score>(
        "score",
        "With fuse_ranks: score of a rank, summed over signatures. reciprocal: 1 / (60 + rank), emphasising first "
        "ranks; borda: number of models - rank."),
};

/// Fuses rankings: ranks each model's row of each matrix (without the model itself; ties: smaller index first) and sums
/// the ranks' scores by weight. The distance is 1 minus the mean of the scores of (i, j) and (j, i), divided by the
/// score of a model that all matrices rank first. The result is symmetric, in [0, 1), zero on the diagonal, and depends
/// only on the order of distances. Models at an infinite distance are unranked and score 0; pairs unranked in both rows
/// of all matrices stay at an infinite distance. Throws as sum_of_distances() does.
DistanceMatrix fusion_of_ranks(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                               RankScore score = RankFusionOptions{}.score);

}  // namespace shapegauge
