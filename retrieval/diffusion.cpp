// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/diffusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

namespace {

constexpr Eigen::Index columns_at_once = 16;  // two cache lines per row

constexpr std::array diffusion_table = {
    option_of<&DiffusionOptions::neighbours>(
        "neighbours", {.low = 1, .high = 1000},
        "Number of nearest neighbours per model in the random walk's graph; about half "
        "the class size is good. Results for a list (auto: "
        "4,5,7,10,14,20) are averaged.",
        automatic_neighbours),
    option_of<&DiffusionOptions::damping>(
        "damping", {.low = 0, .high = 1, .high_open = true},
        "Probability that a random walk continues; higher values reach farther neighbours."),
    option_of<&DiffusionOptions::tie>("tie", {.low = 0, .high = 1},
                                      "Weight of the original distance, added to break ties."),
    option_of<&DiffusionOptions::keep_nearest>("keep_nearest", "Keep each model's original nearest neighbour first."),
};
constexpr auto diffusion_parameters = parameters_of(diffusion_table);

void check(const DiffusionOptions& options) { check_options("diffusion", diffusion_table, options); }

/// Contribution of the original distances to the new ones.
struct OriginalShare {
  double factor = 1;   ///< overflow_safe_factor()
  double share = 0;    ///< of distances that are multiplied by the factor
  double largest = 0;  ///< contribution of the largest finite distance

  /// Computes `contribution` divided by `unit`, which includes the factor; 0 for a unit of 0.
  OriginalShare(double contribution, double unit, double safe, double largest_distance)
      : factor(safe),
        share(unit > 0 ? contribution / unit : 0),
        largest(std::min(share * (safe * largest_distance), std::numeric_limits<double>::max())) {}

  template <typename New, typename Old>
  [[nodiscard]] DistanceMatrix added_to(const New& new_distances, const Old& distances) const {
    if (factor == 1) return new_distances + share * distances;
    return new_distances + share * (factor * distances);
  }
};

/// Sets new distances to joined(row, column) where the original ones are infinite, and limits overflowing ones to the
/// largest number.
template <typename Joined>
void settle_infinite(const DistanceMatrix& distances, const Joined& joined, DistanceMatrix& result) {
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      double& distance = result(i, j);
      if (std::isinf(distances(i, j))) {
        distance = joined(i, j);
      } else {
        distance = std::min(distance, std::numeric_limits<double>::max());
      }
    }
  }
}

/// Computes exp(-distance^2 / (scale_a scale_b)), by logarithms if a product overflows or underflows.
double affinity_of(double distance, double scale_a, double scale_b) {
  if (!(distance > 0)) return 1;
  const double square = distance * distance;
  const double product = scale_a * scale_b;
  if (std::isnormal(square) && std::isnormal(product)) return std::exp(-square / product);
  return std::exp(-std::exp(2 * std::log(distance) - std::log(scale_a) - std::log(scale_b)));
}

/// Returns `count` consecutive indices.
std::vector<Eigen::Index> counted_from(Eigen::Index first, Eigen::Index count) {
  std::vector<Eigen::Index> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), first);
  return indices;
}

/// Returns per model the least model connected to it by the edges of any of the graphs.
std::vector<std::int32_t> components_of(const std::vector<WalkGraph>& graphs, std::size_t models) {
  DisjointSets components;
  components.grow_to(models);
  for (const WalkGraph& graph : graphs) {
    for (Eigen::Index row = 0; row < graph.rows(); ++row) {
      for (WalkGraph::InnerIterator entry(graph, row); entry; ++entry) {
        if (entry.value() > 0) components.join(static_cast<std::int32_t>(row), static_cast<std::int32_t>(entry.col()));
      }
    }
  }
  std::vector<std::int32_t> least(models);
  for (std::size_t i = 0; i < models; ++i) least[i] = components.find(static_cast<std::int32_t>(i));
  return least;
}

/// Graphs of a diffusion, one for each number of neighbours, with the conversion of similarities to distances.
struct Diffusion {
  double damping;
  std::vector<WalkGraph> graphs;
  std::vector<std::int32_t> components;
  OriginalShare original;

  Diffusion(const NearestModels& nearest, const DiffusionOptions& options)
      : Diffusion(neighbour_counts(options.neighbours), nearest, options) {}

  /// Converts rows of similarities and distances, from `first` on, to new distances.
  [[nodiscard]] DistanceMatrix distances_of(const DistanceMatrix& similarities, const DistanceMatrix& distances,
                                            Eigen::Index first) const {
    const auto walked = 1 - similarities.array();
    DistanceMatrix result = original.added_to(walked, distances.array());
    const auto component = [&](Eigen::Index model) { return components[static_cast<std::size_t>(model)]; };
    settle_infinite(
        distances,
        [&](Eigen::Index i, Eigen::Index j) {
          return component(first + i) == component(j) ? walked(i, j) + original.largest
                                                      : std::numeric_limits<double>::infinity();
        },
        result);
    return result;
  }

 private:
  Diffusion(const std::vector<int>& counts, const NearestModels& nearest, const DiffusionOptions& options)
      : damping(options.damping),
        graphs(graphs_of(nearest, counts)),
        components(components_of(graphs, static_cast<std::size_t>(nearest.indices.rows()))),
        original(original_of(nearest, options.tie)) {}

  static std::vector<WalkGraph> graphs_of(const NearestModels& nearest, const std::vector<int>& counts) {
    std::vector<WalkGraph> graphs;
    for (const int count : counts) graphs.push_back(diffusion_graph(nearest, count));
    return graphs;
  }

  static OriginalShare original_of(const NearestModels& nearest, double tie) {
    const double factor = overflow_safe_factor(nearest.largest);
    return {tie, mean_distance(with_scaled_distances(nearest, factor).distances), factor, nearest.largest};
  }
};

/// Returns a distance just below another one; 0 for 0. Errors of the solver can make similarities exceed 1, and
/// distances negative.
double just_below(double distance) {
  return distance == 0 ? 0 : std::nextafter(distance, -std::numeric_limits<double>::infinity());
}

/// Moves the nearest model before diffusion in front of the others, for rows from `first` on.
void put_nearest_first(const NearestModels& before, Eigen::Index first, DistanceMatrix& rows) {
  if (before.indices.cols() == 0) return;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Eigen::Index model = first + i;
    const std::int32_t nearest = before.indices(model, 0);
    if (nearest < 0) continue;
    for (Eigen::Index j = 0; j < rows.cols(); ++j) {
      if (j != model && j != nearest && rows(i, j) <= rows(i, nearest)) rows(i, nearest) = just_below(rows(i, j));
    }
  }
}

/// Moves a model in front of the others; it replaces the last one if it is not among them.
void put_first(Eigen::Index model, std::vector<RankedModel>& found) {
  if (found.front().model == model) return;
  const double distance = just_below(found.front().distance);
  auto entry = std::ranges::find(found, model, &RankedModel::model);
  if (entry == found.end()) --entry;
  std::rotate(found.begin(), entry, entry + 1);
  found.front() = {.model = model, .distance = distance};
}

/// Computes the similarities of all models.
Eigen::MatrixXd dense_similarities(const Diffusion& diffusion) {
  Eigen::MatrixXd mean;
  for (const WalkGraph& graph : diffusion.graphs) {
    Eigen::MatrixXd system = -diffusion.damping * Eigen::MatrixXd(graph);
    system.diagonal().array() += 1;
    Eigen::MatrixXd affinities = positive_definite_inverse(std::move(system));
    if (diffusion.graphs.size() == 1) return (1 - diffusion.damping) * affinities;
    const Eigen::VectorXd root = affinities.diagonal().cwiseSqrt().cwiseInverse();
    const auto normalised = root.asDiagonal() * affinities * root.asDiagonal();
    if (mean.size() == 0) mean = Eigen::MatrixXd::Zero(graph.rows(), graph.cols());
    mean += normalised / static_cast<double>(diffusion.graphs.size());
  }
  return mean;
}

/// Returns, by graph, the diagonals' inverse square roots if similarities are normalised.
std::vector<Eigen::VectorXd> diagonal_roots(const Diffusion& diffusion) {
  std::vector<Eigen::VectorXd> roots;
  if (diffusion.graphs.size() == 1) return roots;
  for (const WalkGraph& graph : diffusion.graphs) {
    roots.emplace_back(diffused_diagonal(graph, diffusion.damping).cwiseSqrt().cwiseInverse());
  }
  return roots;
}

/// Computes `count` rows of the similarities from `first` on.
DistanceMatrix similarity_rows(const Diffusion& diffusion, const std::vector<Eigen::VectorXd>& roots,
                               Eigen::Index first, Eigen::Index count) {
  DistanceMatrix mean;
  for (std::size_t k = 0; k < diffusion.graphs.size(); ++k) {
    const DistanceMatrix affinities = diffused_affinities(diffusion.graphs[k], first, count, diffusion.damping);
    if (roots.empty()) return (1 - diffusion.damping) * affinities;
    const auto normalised = roots[k].segment(first, count).asDiagonal() * affinities * roots[k].asDiagonal();
    if (k == 0) mean = DistanceMatrix::Zero(count, affinities.cols());
    mean += normalised / static_cast<double>(roots.size());
  }
  return mean;
}

/// Lazy answer to one query: a model's similarity needs its entry of the diagonal, which costs as much as the query's
/// own column.
class QueryDiffusion {
 public:
  QueryDiffusion(const NearestModels& nearest, Eigen::Index query, const Eigen::VectorXd& distances,
                 const DiffusionOptions& options)
      : diffusion_(nearest, options), query_(query), distances_(distances.transpose()) {
    const bool normalised = diffusion_.graphs.size() > 1;
    for (const WalkGraph& graph : diffusion_.graphs) {
      Eigen::RowVectorXd column = diffused_affinities(graph, query, 1, diffusion_.damping);
      column *= normalised ? 1 / std::sqrt(column[query]) : 1 - diffusion_.damping;
      columns_.push_back(std::move(column));
      if (normalised) solvers_.emplace_back(graph, diffusion_.damping);
    }
  }

  /// Returns a lower bound of each model's new distance: entries of the diagonal are at least 1.
  [[nodiscard]] Eigen::VectorXd lower_bounds() const {
    constexpr double rounding = 1e-5;  // the solvers' tolerance, and some more
    DistanceMatrix similarities = DistanceMatrix::Zero(1, distances_.cols());
    for (const Eigen::RowVectorXd& column : columns_) similarities += column / static_cast<double>(columns_.size());
    return diffusion_.distances_of(similarities, distances_, query_).row(0).array() - rounding;
  }

  /// Computes the new distances of these models.
  [[nodiscard]] Eigen::VectorXd distances_of(std::span<const Eigen::Index> models) const {
    DistanceMatrix similarities = DistanceMatrix::Zero(1, distances_.cols());
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      Eigen::VectorXd diagonal = Eigen::VectorXd::Ones(std::ssize(models));
      if (!solvers_.empty()) diagonal = solvers_[k].entries(models);
      for (std::size_t i = 0; i < models.size(); ++i) {
        similarities(0, models[i]) += columns_[k][models[i]] / std::sqrt(diagonal[static_cast<Eigen::Index>(i)]) /
                                      static_cast<double>(columns_.size());
      }
    }
    return diffusion_.distances_of(similarities, distances_, query_).row(0)(models);
  }

 private:
  Diffusion diffusion_;
  Eigen::Index query_;
  DistanceMatrix distances_;                 ///< one row
  std::vector<Eigen::RowVectorXd> columns_;  ///< by graph, over the root of the query's own entry
  std::vector<DiagonalSolver> solvers_;      ///< by graph; none where similarities are not normalised
};

/// Calls visit(first, count) for groups of columns, in parallel.
template <typename Visit>
void for_column_groups(Eigen::Index count, const Visit& visit) {
  const Eigen::Index groups = (count + columns_at_once - 1) / columns_at_once;
  parallel_for(Eigen::Index{0}, groups, [&](Eigen::Index group) {
    const Eigen::Index begin = group * columns_at_once;
    visit(begin, std::min(columns_at_once, count - begin));
  });
}

}  // namespace

WalkGraph diffusion_graph(const NearestModels& nearest, int k) {
  const Eigen::Index models = nearest.indices.rows();
  const Eigen::Index count = std::min<Eigen::Index>(k, nearest.indices.cols());
  WalkGraph graph(models, models);
  if (count == 0) return graph;
  Eigen::VectorXd scales = nearest.distances.leftCols(count).rowwise().mean();
  for (Eigen::Index i = 0; i < models; ++i) {
    if (!std::isfinite(scales[i])) scales[i] = mean_distance(nearest.distances.row(i).head(count));
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < models; ++i) {
    for (Eigen::Index n = 0; n < count; ++n) {
      const std::int32_t j = nearest.indices(i, n);
      if (j < 0) break;
      const double affinity = affinity_of(nearest.distances(i, n), scales[i], scales[j]);
      const auto row = static_cast<int>(i);
      entries.emplace_back(row, j, affinity / 2);
      entries.emplace_back(j, row, affinity / 2);
    }
  }
  graph.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd degrees = graph * Eigen::VectorXd::Ones(models);
  // If all affinities underflow, the walk does not leave the model.
  const Eigen::VectorXd inverse_root = (degrees.array() > 0).select(degrees.array().rsqrt(), 0.0);
  return inverse_root.asDiagonal() * graph * inverse_root.asDiagonal();
}

DistanceMatrix diffused_affinities(const WalkGraph& graph, Eigen::Index first, Eigen::Index count, double damping) {
  DistanceMatrix rows(count, graph.cols());
  const ColumnSolver solver(graph, damping);
  for_column_groups(count, [&](Eigen::Index begin, Eigen::Index some) {
    rows.middleRows(begin, some) = solver.columns(first + begin, some).transpose().cast<double>();
  });
  return rows;
}

Eigen::VectorXd diffused_diagonal(const WalkGraph& graph, double damping) {
  Eigen::VectorXd diagonal(graph.rows());
  const DiagonalSolver solver(graph, damping);
  for_column_groups(graph.rows(), [&](Eigen::Index begin, Eigen::Index some) {
    diagonal.segment(begin, some) = solver.entries(counted_from(begin, some));
  });
  return diagonal;
}

void diffuse(Eigen::Index models, const RowSource& rows, const DiffusionOptions& options,
             const std::function<void(Eigen::Index first, const DistanceMatrix& rows)>& visit) {
  check(options);
  const NearestModels nearest = nearest_models(models, neighbour_counts(options.neighbours).back(), rows);
  const Diffusion diffusion(nearest, options);
  const std::vector<Eigen::VectorXd> roots = diagonal_roots(diffusion);
  for_each_block(models, rows, [&](Eigen::Index first, const DistanceMatrix& block) {
    const DistanceMatrix similarities = similarity_rows(diffusion, roots, first, block.rows());
    DistanceMatrix result = diffusion.distances_of(similarities, block, first);
    for (Eigen::Index i = 0; i < result.rows(); ++i) result(i, first + i) = 0;
    if (options.keep_nearest) put_nearest_first(nearest, first, result);
    visit(first, result);
  });
}

std::vector<RankedModel> diffused_nearest(const NearestModels& nearest, Eigen::Index query,
                                          const Eigen::VectorXd& distances, const DiffusionOptions& options,
                                          std::size_t count) {
  check(options);
  const QueryDiffusion diffusion(nearest, query, distances, options);
  const Eigen::VectorXd bounds = diffusion.lower_bounds();
  std::vector<Eigen::Index> order = counted_from(0, bounds.size());
  order.erase(order.begin() + query);
  std::ranges::stable_sort(order, {}, [&](Eigen::Index model) { return bounds[model]; });
  const auto nearer = [](const RankedModel& a, const RankedModel& b) {
    return std::pair(a.distance, a.model) < std::pair(b.distance, b.model);
  };
  std::vector<RankedModel> found;
  for (auto next = order.begin(); next != order.end();) {
    if (count == 0 || (found.size() >= count && bounds[*next] > found[count - 1].distance)) break;
    const auto end = next + std::min<std::ptrdiff_t>(columns_at_once, order.end() - next);
    const std::span<const Eigen::Index> some(next, end);
    const Eigen::VectorXd exact = diffusion.distances_of(some);
    for (std::size_t i = 0; i < some.size(); ++i) found.push_back({some[i], exact[static_cast<Eigen::Index>(i)]});
    std::ranges::sort(found, nearer);
    next = end;
    check_interruption();
  }
  found.resize(std::min(found.size(), count));
  const Eigen::Index original_nearest =
      options.keep_nearest && nearest.indices.cols() > 0 ? nearest.indices(query, 0) : -1;
  if (original_nearest >= 0 && !found.empty()) put_first(original_nearest, found);
  return found;
}

NearestModels append_query(NearestModels nearest, const Eigen::VectorXd& distances, int k) {
  const Eigen::Index models = nearest.indices.rows();
  const Eigen::Index before = nearest.indices.cols();
  const Eigen::Index count = std::clamp<Eigen::Index>(models, 0, k);
  nearest.indices.conservativeResize(models + 1, count);
  nearest.distances.conservativeResize(models + 1, count);
  const auto insert = [&](Eigen::Index row, Eigen::Index filled, std::int32_t model, double distance) {
    Eigen::Index rank = filled;
    while (rank > 0 && nearest.distances(row, rank - 1) > distance) --rank;
    if (rank >= count) return;
    for (Eigen::Index n = std::min(filled, count - 1); n > rank; --n) {
      nearest.indices(row, n) = nearest.indices(row, n - 1);
      nearest.distances(row, n) = nearest.distances(row, n - 1);
    }
    nearest.indices(row, rank) = std::isfinite(distance) ? model : -1;
    nearest.distances(row, rank) = distance;
  };
  const auto added = static_cast<std::int32_t>(models);
  for (Eigen::Index i = 0; i < models; ++i) insert(i, std::min(before, count), added, distances[i]);
  for (Eigen::Index i = 0; i < models; ++i) {
    insert(models, std::min(i, count), static_cast<std::int32_t>(i), distances[i]);
    if (std::isfinite(distances[i])) nearest.largest = std::max(nearest.largest, distances[i]);
  }
  return nearest;
}

DistanceMatrix diffused(const DistanceMatrix& distances, const DiffusionOptions& options) {
  check(options);
  const NearestModels nearest =
      nearest_models(distances.rows(), neighbour_counts(options.neighbours).back(), rows_of(distances));
  const Diffusion diffusion(nearest, options);
  DistanceMatrix result = symmetrise(diffusion.distances_of(dense_similarities(diffusion), distances, 0));
  if (options.keep_nearest) put_nearest_first(nearest, 0, result);
  return result;
}

DiffusionOptions diffusion_options(const ParameterValues& values) { return options_from(diffusion_table, values); }

RerankMethod diffusion_method() {
  return {"diffusion", "Diffusion: random walks between neighbouring models.", diffusion_parameters,
          [](const DistanceMatrix& distances, const ParameterValues& values) {
            return diffused(distances, diffusion_options(values));
          }};
}

}  // namespace shapegauge
