#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "shapegauge/core/base/parameter.h"
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

/// The k nearest others of each of n models.
struct NearestModels {
  /// n x k, nearest first; of equal distances the lesser index first. -1 where a model has fewer at a finite distance.
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> indices;
  DistanceMatrix distances;  ///< n x k; infinite where the index is -1
  double largest = 0;        ///< finite distance between any two models
};

/// Rows of a distance matrix, `count` from `first` on, so that the whole need never be in memory; distance_rows() of
/// signatures, for example.
using RowSource = std::function<DistanceMatrix(Eigen::Index first, Eigen::Index count)>;

/// The nearest others among n models, from the rows of their distances; k is lowered to n - 1. Throws
/// ArgumentError for a k below 1, and for rows of another length or with a distance that is negative or NaN.
NearestModels nearest_models(Eigen::Index models, int k, const RowSource& rows);

/// Settings of diffusion.
struct DiffusionOptions {
  int neighbours = 12;  ///< 1 to 1000; k. About half of a class serves well, and a few too many harm less than too few
  double damping = 0.95;  ///< 0 to below 1; a walk goes on with this probability
  double tie = 1e-4;      ///< 0 to 1; share of the original distance, which orders what no walk tells apart
};

/// The symmetric graph on which a walk goes from model to model: affinities exp(-d^2 / (s_i s_j)) between the k nearest
/// neighbours, s being a model's mean distance to them (Zelnik-Manor and Perona 2004); A = (W + W^T) / 2, then
/// D^-1/2 A D^-1/2. Throws InputError for options out of range.
Eigen::SparseMatrix<double, Eigen::RowMajor> diffusion_graph(const NearestModels& nearest,
                                                             const DiffusionOptions& options = {});

/// Rows of the diffused affinities F = (I - damping graph)^-1 (Zhou et al. 2004; Donoser and Bischof 2013), `count`
/// from `first` on, to about 1e-6 by Chebyshev iteration on the sparse system, some rows at once: 20,000 models need no
/// inverse.
DistanceMatrix diffused_affinities(const Eigen::SparseMatrix<double, Eigen::RowMajor>& graph, Eigen::Index first,
                                   Eigen::Index count, const DiffusionOptions& options = {});

/// Diffusion of a set of models: calls visit(first, rows) with the new distances, 1 - (1 - damping) F, plus `tie` times
/// the distance over the mean distance to the k nearest, some rows at a time from the first on. Neighbours join all
/// models between which a walk can go. The original rows are asked for twice. Throws as nearest_models() and
/// diffusion_graph().
void diffuse(Eigen::Index models, const RowSource& rows, const DiffusionOptions& options,
             const std::function<void(Eigen::Index first, const DistanceMatrix& rows)>& visit);

/// The same for a matrix in memory, by one dense factorisation, made symmetric. Throws ArgumentError as above
/// and for a matrix that is not square.
DistanceMatrix diffused(const DistanceMatrix& distances, const DiffusionOptions& options = {});

/// Settings of k_reciprocal().
struct ReciprocalOptions {
  int neighbours = 16;           ///< 1 to 1000; k1 of the paper
  int expansion_neighbours = 6;  ///< 1 to neighbours; k2
  double original = 0.3;         ///< 0 to 1; the share of the original distance, over its largest in the matrix
};

/// k-reciprocal re-ranking (Zhong, Zheng, Cao, Li 2017): the Jaccard distance of models' sets of neighbours that are
/// each other's neighbours, taken up with Gaussian weights, each averaged over its nearest. Neighbours join models
/// whose sets have a model in common. Throws InputError for options out of range, and as diffused().
DistanceMatrix k_reciprocal(const DistanceMatrix& distances, const ReciprocalOptions& options = {});

/// Settings of query_expansion().
struct ExpansionOptions {
  int neighbours = 4;  ///< 1 to 1000
};

/// Average query expansion (Chum et al. 2007), on distances: each row becomes the mean of its own and its nearest
/// neighbours' rows, the r-th with weight 1 / (1 + r); then made symmetric. Neighbours join a model to those at a
/// finite distance from one of them. Throws InputError for options out of range, and as diffused().
DistanceMatrix query_expansion(const DistanceMatrix& distances, const ExpansionOptions& options = {});

/// A way to re-rank that configurations and commands know by name. Functions throw InputError for settings out of
/// range.
struct RerankMethod {
  std::string_view name;
  std::string_view description;  ///< one sentence
  std::span<const Parameter> parameters;
  DistanceMatrix (*rerank)(const DistanceMatrix&, const ParameterValues&) = nullptr;
};

/// All ways to re-rank.
std::span<const RerankMethod> rerank_methods();

/// The way of that name. Throws InputError, naming those there are.
const RerankMethod& rerank_method(std::string_view name);

/// The options of the values of the parameters of "diffusion", for diffuse().
DiffusionOptions diffusion_options(const ParameterValues& values);

}  // namespace shapegauge
