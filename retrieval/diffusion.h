// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "shapegauge/retrieval/graph_inverse.h"
#include "shapegauge/retrieval/nearest_models.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Options of diffuse() and diffused().
struct DiffusionOptions {
  /// Numbers of neighbours k, from 1 to 1000. The result is the mean over several k. An empty list ("auto") means 4,
  /// 5, 7, 10, 14 and 20. A good choice is half of the class size; too many are better than too few.
  IntegerList neighbours = 12;
  double damping = 0.95;      ///< probability that the random walk continues, from 0 to below 1
  double tie = 1e-4;          ///< weight of the original distance, from 0 to 1, which breaks ties after diffusion
  bool keep_nearest = false;  ///< true: the nearest neighbour of a model before diffusion stays the nearest
};

/// Computes the symmetric normalised affinity matrix of a random walk on the k nearest neighbours. The matrix W has the
/// affinities exp(-d^2 / (s_i s_j)) of model i and its neighbours j, where s is a model's mean distance to its
/// neighbours (Zelnik-Manor and Perona 2004). With A = (W + W^T) / 2 and D the diagonal matrix of the row sums of A,
/// returns D^-1/2 A D^-1/2. k is limited to the available neighbours.
WalkGraph diffusion_graph(const NearestModels& nearest, int k);

/// Computes `count` rows, from row `first` on, of the diffused affinities F = (I - damping graph)^-1 (Zhou et al. 2004;
/// Donoser and Bischof 2013). Solves the sparse system for several rows at once by Chebyshev iteration, without an
/// inverse. The error is about 1e-6 of the largest affinity for a damping of at most 0.999; single precision makes it
/// 1e-5 at 0.9999 and 4e-4 at 0.99999. The damping is from 0 to below 1.
DistanceMatrix diffused_affinities(const WalkGraph& graph, Eigen::Index first, Eigen::Index count, double damping);

/// Computes the diagonal of the matrix of diffused_affinities(), with an error of about 1e-6, at half the cost of the
/// whole matrix.
Eigen::VectorXd diffused_diagonal(const WalkGraph& graph, double damping);

/// Diffuses the distances of a set of models and calls visit(first, rows) with blocks of rows of the new distance
/// matrix, in order; `first` is the index of a block's first row.
///
/// The new distances are 1 - S plus `tie` times the distance divided by the mean distance to the k nearest. For one k,
/// S = (1 - damping) F. For several, S is the mean over k of F_ij / sqrt(F_ii F_jj), and the mean distance is that to
/// the nearest of the largest k. With `keep_nearest`, the model that was nearest gets a distance just below the others
/// of the row, if it is not the nearest. Models are connected (rerank.h) if a walk connects them. Requests the original
/// rows twice. Throws InputError for options out of range, and as nearest_models() does.
void diffuse(Eigen::Index models, const RowSource& rows, const DiffusionOptions& options,
             const std::function<void(Eigen::Index first, const DistanceMatrix& rows)>& visit);

/// Diffuses a distance matrix in memory as diffuse() does, by a dense factorisation for each number of neighbours k in
/// the options. Returns a symmetric matrix, apart from the entries that `keep_nearest` sets. Throws ArgumentError as
/// diffuse() does and for a matrix that is not square.
DistanceMatrix diffused(const DistanceMatrix& distances, const DiffusionOptions& options = {});

/// Returns the `count` nearest models of the model `query` after diffusion, without the model itself, nearest first
/// (ties: smaller index first). The result agrees with the model's row of diffuse() to about 1e-6, without computing
/// the other rows. `nearest` are the nearest models before diffusion, as many as the largest of neighbour_counts();
/// `distances` are the distances from `query` to all models before diffusion. Throws ArgumentError for options out of
/// range.
std::vector<RankedModel> diffused_nearest(const NearestModels& nearest, Eigen::Index query,
                                          const Eigen::VectorXd& distances, const DiffusionOptions& options,
                                          std::size_t count);

/// Appends a query to a collection as its last model and returns the k nearest models of each model, the query
/// included. `nearest` are the k nearest models within the collection alone; `distances` are the distances from the
/// query to the collection's models.
NearestModels append_query(NearestModels nearest, const Eigen::VectorXd& distances, int k);

/// Converts parameter values of diffusion_method() to options.
DiffusionOptions diffusion_options(const ParameterValues& values);

/// Returns the entry "diffusion" of the registry rerank_methods().
RerankMethod diffusion_method();

}  // namespace shapegauge
