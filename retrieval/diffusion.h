#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <functional>
#include <vector>

#include "shapegauge/retrieval/nearest_models.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Settings of diffusion.
struct DiffusionOptions {
  /// k, each from 1 to 1000. Of several, and of none ("auto", neighbour_counts()), the mean is taken. About half of a
  /// class serves well, and a few too many harm less than too few.
  IntegerList neighbours = 12;
  double damping = 0.95;  ///< 0 to below 1; a walk goes on with this probability
  double tie = 1e-4;      ///< 0 to 1; share of the original distance, which orders what no walk tells apart
};

/// The symmetric graph on which a walk goes from model to model: affinities exp(-d^2 / (s_i s_j)) between the k nearest
/// neighbours, s being a model's mean distance to them (Zelnik-Manor and Perona 2004); A = (W + W^T) / 2, then
/// D^-1/2 A D^-1/2. k is lowered to the neighbours that there are.
Eigen::SparseMatrix<double, Eigen::RowMajor> diffusion_graph(const NearestModels& nearest, int k);

/// Rows of the diffused affinities F = (I - damping graph)^-1 (Zhou et al. 2004; Donoser and Bischof 2013), `count`
/// from `first` on, to about 1e-6 by Chebyshev iteration on the sparse system, some rows at once: 20,000 models need no
/// inverse. The damping is from 0 to below 1.
DistanceMatrix diffused_affinities(const Eigen::SparseMatrix<double, Eigen::RowMajor>& graph, Eigen::Index first,
                                   Eigen::Index count, double damping);

/// The diagonal of the diffused affinities, to about 1e-6, at half the cost of their rows.
Eigen::VectorXd diffused_diagonal(const Eigen::SparseMatrix<double, Eigen::RowMajor>& graph, double damping);

/// Diffusion of a set of models: calls visit(first, rows) with the new distances, some rows at a time from the first
/// on. They are 1 - S plus `tie` times the distance over the mean distance to the k nearest. For one k,
/// S = (1 - damping) F. For several, S is the mean over k of F_ij / sqrt(F_ii F_jj), and the mean distance is that to
/// the greatest k nearest. Neighbours join all models between which a walk can go. The original rows are asked for
/// twice. Throws InputError for options out of range, and as nearest_models().
void diffuse(Eigen::Index models, const RowSource& rows, const DiffusionOptions& options,
             const std::function<void(Eigen::Index first, const DistanceMatrix& rows)>& visit);

/// The same for a matrix in memory, by a dense factorisation for each k, made symmetric. Throws ArgumentError
/// as above and for a matrix that is not square.
DistanceMatrix diffused(const DistanceMatrix& distances, const DiffusionOptions& options = {});

/// A model of an answer.
struct RankedModel {
  Eigen::Index model = 0;
  double distance = 0;
};

/// The `count` nearest models of one model after diffusion, nearest first (of equal distances the lesser index first),
/// without itself: those that diffuse() has in its row, to about 1e-6, without the other rows. `nearest`: of the models
/// before, the greatest of neighbour_counts() of them; `distances`: of the model to all, before. Throws ArgumentError
/// for options out of range.
std::vector<RankedModel> diffused_nearest(const NearestModels& nearest, Eigen::Index query,
                                          const Eigen::VectorXd& distances, const DiffusionOptions& options,
                                          std::size_t count);

/// nearest_models() of a collection to which one more model comes, last, at these distances: with k for all of them.
/// `nearest`: k of the collection alone.
NearestModels with_query(NearestModels nearest, const Eigen::VectorXd& distances, int k);

/// The options of the values of the method's parameters.
DiffusionOptions diffusion_options(const ParameterValues& values);

RerankMethod diffusion_method();

}  // namespace shapegauge
