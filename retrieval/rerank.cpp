#include "shapegauge/retrieval/rerank.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/retrieval/positive_definite_inverse.h"

namespace shapegauge {

namespace {

using Graph = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using SparseRow = std::vector<std::pair<std::int32_t, double>>;  // by column

constexpr Eigen::Index rows_at_once = 256;

constexpr std::array diffusion_table = {
    option_of<&DiffusionOptions::neighbours>("neighbours", {.low = 1, .high = 1000},
                                             "Nearest models that a walk goes on to: about half of a class."),
    option_of<&DiffusionOptions::damping>("damping", {.low = 0, .high = 1, .high_open = true},
                                          "A walk goes on with this probability."),
    option_of<&DiffusionOptions::tie>("tie", {.low = 0, .high = 1},
                                      "Share of the original distance, which orders what no walk tells apart."),
};
constexpr std::array reciprocal_table = {
    option_of<&ReciprocalOptions::neighbours>("neighbours", {.low = 1, .high = 1000},
                                              "Nearest models among which those of each other are sought."),
    option_of<&ReciprocalOptions::expansion_neighbours>(
        "expansion_neighbours", {.low = 1, .high = 1000},
        "Nearest models over which sets are averaged; at most neighbours."),
    option_of<&ReciprocalOptions::original>("original", {.low = 0, .high = 1}, "Share of the original distance."),
};
constexpr std::array expansion_table = {
    option_of<&ExpansionOptions::neighbours>("neighbours", {.low = 1, .high = 1000},
                                             "Nearest models whose rows are added to a model's own."),
};
constexpr auto diffusion_parameters = parameters_of(diffusion_table);
constexpr auto reciprocal_parameters = parameters_of(reciprocal_table);
constexpr auto expansion_parameters = parameters_of(expansion_table);

void check(const DiffusionOptions& options) { check_options("diffusion", diffusion_table, options); }

RowSource rows_of(const DistanceMatrix& distances) {
  if (distances.rows() != distances.cols()) {
    throw ArgumentError("only square distance matrices can be re-ranked, not " + std::to_string(distances.rows()) +
                        " x " + std::to_string(distances.cols()));
  }
  return [&distances](Eigen::Index first, Eigen::Index count) -> DistanceMatrix {
    return distances.middleRows(first, count);
  };
}

/// Calls visit(first, rows) for rows of the matrix, some at a time.
template <typename Visit>
void for_each_block(Eigen::Index models, const RowSource& rows, Visit visit) {
  for (Eigen::Index first = 0; first < models; first += rows_at_once) {
    const Eigen::Index count = std::min(rows_at_once, models - first);
    const DistanceMatrix block = rows(first, count);
    if (block.rows() != count || block.cols() != models) {
      throw ArgumentError("rows of " + std::to_string(block.cols()) + " distances for " + std::to_string(models) +
                          " models");
    }
    visit(first, block);
  }
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A power of two that keeps sums and quotients of distances up to `largest` from over- and underflow; 1 if not needed.
double safe_factor(double largest) {
  if (largest > 0x1p960) return 0x1p-64;
  return largest > 0 && largest < 0x1p-960 ? 0x1p512 : 1;
}

/// The mean of distances, of the finite ones where not all are; 0 without any.
template <typename Distances>
double mean_distance(const Distances& distances) {
  const double plain = distances.size() > 0 ? distances.mean() : 0;
  if (std::isfinite(plain)) return plain;
  const double count = static_cast<double>(distances.array().isFinite().count());
  double mean = 0;
  for (const double distance : distances.reshaped()) mean += std::isfinite(distance) ? distance / count : 0;
  return std::min(mean, std::numeric_limits<double>::max());
}

/// The nearest of multiplied distances.
NearestModels multiplied(NearestModels nearest, double factor) {
  if (factor == 1) return nearest;
  nearest.distances *= factor;
  nearest.largest *= factor;
  return nearest;
}

/// What the original distances add to the new ones.
struct OriginalShare {
  double factor = 1;   ///< safe_factor()
  double share = 0;    ///< of distances that are multiplied by the factor
  double largest = 0;  ///< what the largest finite distance adds

  /// `wanted` of the distances over `unit`, which is multiplied by the factor already; 0 where the unit is.
  OriginalShare(double wanted, double unit, double safe, double largest_distance)
      : factor(safe),
        share(unit > 0 ? wanted / unit : 0),
        largest(std::min(share * (safe * largest_distance), std::numeric_limits<double>::max())) {}

  template <typename New, typename Old>
  [[nodiscard]] DistanceMatrix added_to(const New& new_distances, const Old& distances) const {
    if (factor == 1) return new_distances + share * distances;
    return new_distances + share * (factor * distances);
  }
};

/// Sets new distances to joined(row, column) where the original ones are infinite; elsewhere limits those that overflow
/// to the largest number.
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

DistanceMatrix symmetric(const DistanceMatrix& distances) {
  DistanceMatrix result = distances / 2 + distances.transpose() / 2;
  result.diagonal().setZero();
  return result;
}

/// Columns of (I - damping graph)^-1 by the Chebyshev semi-iteration (Golub and Varga 1961): the graph's eigenvalues
/// are between -1 and 1, so the number of steps to a tolerance is known beforehand. In single precision, which is finer
/// than the tolerance; row-major blocks keep what is added to each other side by side.
class ColumnSolver {
 public:
  ColumnSolver(const Graph& graph, double damping)
      : graph_((damping * graph).cast<float>()), squared_damping_(damping * damping) {
    constexpr double tolerance = 1e-6;
    const double rate = damping / (1 + std::sqrt(1 - squared_damping_));
    steps_ = damping > 0 ? static_cast<int>(std::ceil(std::log(2 / tolerance) / -std::log(rate))) : 0;
  }

  using Block = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  [[nodiscard]] Block columns(Eigen::Index first, Eigen::Index count) const {
    Block before = Block::Zero(graph_.rows(), count);
    Block now = before;
    for (Eigen::Index k = 0; k < count; ++k) now(first + k, k) = 1;
    double weight = 1 / (1 - squared_damping_ / 2);
    for (int step = 0; step < steps_; ++step) {
      advance(first, static_cast<float>(weight), now, before);
      now.swap(before);
      weight = 1 / (1 - squared_damping_ * weight / 4);
    }
    return now;
  }

 private:
  /// before += weight (damping graph now + identity columns - before)
  void advance(Eigen::Index first, float weight, const Block& now, Block& before) const {
    const Eigen::Index count = now.cols();
    std::vector<float> sum(static_cast<std::size_t>(count));
    for (Eigen::Index row = 0; row < graph_.rows(); ++row) {
      std::ranges::fill(sum, 0.0F);
      if (row >= first && row < first + count) sum[static_cast<std::size_t>(row - first)] = 1;
      for (Eigen::SparseMatrix<float, Eigen::RowMajor>::InnerIterator entry(graph_, row); entry; ++entry) {
        const float* const values = now.data() + entry.col() * count;
        for (Eigen::Index k = 0; k < count; ++k) sum[static_cast<std::size_t>(k)] += entry.value() * values[k];
      }
      float* const values = before.data() + row * count;
      for (Eigen::Index k = 0; k < count; ++k) values[k] += weight * (sum[static_cast<std::size_t>(k)] - values[k]);
    }
  }

  Eigen::SparseMatrix<float, Eigen::RowMajor> graph_;
  double squared_damping_;
  int steps_;
};

}  // namespace

NearestModels nearest_models(Eigen::Index models, int k, const RowSource& rows) {
  if (k < 1) throw ArgumentError("at least one nearest neighbour must be asked for, not " + std::to_string(k));
  const Eigen::Index count = std::clamp<Eigen::Index>(models - 1, 0, k);
  NearestModels nearest{{models, count}, {models, count}};
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(models);
  for_each_block(models, rows, [&](Eigen::Index first, const DistanceMatrix& block) {
    if (!(block.minCoeff<Eigen::PropagateNaN>() >= 0)) {
      throw ArgumentError("distances between models must be numbers that are not negative");
    }
    parallel_for(Eigen::Index{0}, block.rows(), [&](Eigen::Index i) {
      std::vector<std::int32_t> order(static_cast<std::size_t>(models));
      std::iota(order.begin(), order.end(), 0);
      order.erase(order.begin() + first + i);
      std::ranges::partial_sort(order, order.begin() + count, {},
                                [&](std::int32_t j) { return std::pair(block(i, j), j); });
      for (Eigen::Index n = 0; n < count; ++n) {
        const std::int32_t j = order[static_cast<std::size_t>(n)];
        nearest.indices(first + i, n) = std::isfinite(block(i, j)) ? j : -1;
        nearest.distances(first + i, n) = block(i, j);
      }
      for (const std::int32_t j : order) {
        if (std::isfinite(block(i, j))) largest[first + i] = std::max(largest[first + i], block(i, j));
      }
    });
  });
  if (models > 0) nearest.largest = largest.maxCoeff();
  return nearest;
}

namespace {

/// exp(-distance^2 / (scale_a scale_b)), by logarithms where a product over- or underflows.
double affinity_of(double distance, double scale_a, double scale_b) {
  if (!(distance > 0)) return 1;
  const double square = distance * distance;
  const double product = scale_a * scale_b;
  if (std::isnormal(square) && std::isnormal(product)) return std::exp(-square / product);
  return std::exp(-std::exp(2 * std::log(distance) - std::log(scale_a) - std::log(scale_b)));
}

/// By model, the number of its connected component of the graph.
std::vector<Eigen::Index> parts_of(const Graph& graph) {
  std::vector<Eigen::Index> leaders(static_cast<std::size_t>(graph.rows()));
  std::iota(leaders.begin(), leaders.end(), Eigen::Index{0});
  const auto find = [&](Eigen::Index model) {
    const auto leader_of = [&](Eigen::Index i) -> Eigen::Index& { return leaders[static_cast<std::size_t>(i)]; };
    while (leader_of(model) != model) model = leader_of(model) = leader_of(leader_of(model));
    return model;
  };
  for (Eigen::Index row = 0; row < graph.rows(); ++row) {
    for (Graph::InnerIterator entry(graph, row); entry; ++entry) {
      if (entry.value() > 0) leaders[static_cast<std::size_t>(find(row))] = find(entry.col());
    }
  }
  std::vector<Eigen::Index> parts(leaders.size());
  for (Eigen::Index model = 0; model < graph.rows(); ++model) parts[static_cast<std::size_t>(model)] = find(model);
  return parts;
}

/// The graph of a diffusion, and the distances that follow from affinities on it.
struct Diffusion {
  DiffusionOptions options;
  Graph graph;
  std::vector<Eigen::Index> parts;
  OriginalShare original;

  Diffusion(const NearestModels& nearest, const DiffusionOptions& given)
      : options(given),
        graph(diffusion_graph(nearest, given)),
        parts(parts_of(graph)),
        original(original_of(nearest)) {}

  /// New distances, from the affinities and distances of rows from `first` on.
  [[nodiscard]] DistanceMatrix distances_of(const DistanceMatrix& affinities, const DistanceMatrix& distances,
                                            Eigen::Index first) const {
    const auto walked = 1 - (1 - options.damping) * affinities.array();
    DistanceMatrix result = original.added_to(walked, distances.array());
    const auto part = [&](Eigen::Index model) { return parts[static_cast<std::size_t>(model)]; };
    settle_infinite(
        distances,
        [&](Eigen::Index i, Eigen::Index j) {
          return part(first + i) == part(j) ? walked(i, j) + original.largest : infinity;
        },
        result);
    return result;
  }

 private:
  [[nodiscard]] OriginalShare original_of(const NearestModels& nearest) const {
    const double factor = safe_factor(nearest.largest);
    return {options.tie, mean_distance(multiplied(nearest, factor).distances), factor, nearest.largest};
  }
};

}  // namespace

Graph diffusion_graph(const NearestModels& nearest, const DiffusionOptions& options) {
  check(options);
  const Eigen::Index models = nearest.indices.rows();
  const Eigen::Index count = std::min<Eigen::Index>(options.neighbours, nearest.indices.cols());
  Graph graph(models, models);
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
  // Where all affinities vanish, the walk does not leave.
  const Eigen::VectorXd inverse_root = (degrees.array() > 0).select(degrees.array().rsqrt(), 0.0);
  return inverse_root.asDiagonal() * graph * inverse_root.asDiagonal();
}

DistanceMatrix diffused_affinities(const Graph& graph, Eigen::Index first, Eigen::Index count,
                                   const DiffusionOptions& options) {
  check(options);
  DistanceMatrix rows(count, graph.cols());
  const ColumnSolver solver(graph, options.damping);
  constexpr Eigen::Index columns_at_once = 16;  // two cache lines a row
  const Eigen::Index groups = (count + columns_at_once - 1) / columns_at_once;
  parallel_for(Eigen::Index{0}, groups, [&](Eigen::Index group) {
    const Eigen::Index begin = group * columns_at_once;
    const Eigen::Index some = std::min(columns_at_once, count - begin);
    rows.middleRows(begin, some) = solver.columns(first + begin, some).transpose().cast<double>();
  });
  return rows;
}

void diffuse(Eigen::Index models, const RowSource& rows, const DiffusionOptions& options,
             const std::function<void(Eigen::Index first, const DistanceMatrix& rows)>& visit) {
  check(options);
  const Diffusion diffusion(nearest_models(models, options.neighbours, rows), options);
  for_each_block(models, rows, [&](Eigen::Index first, const DistanceMatrix& block) {
    const DistanceMatrix affinities = diffused_affinities(diffusion.graph, first, block.rows(), options);
    DistanceMatrix result = diffusion.distances_of(affinities, block, first);
    for (Eigen::Index i = 0; i < result.rows(); ++i) result(i, first + i) = 0;
    visit(first, result);
  });
}

DistanceMatrix diffused(const DistanceMatrix& distances, const DiffusionOptions& options) {
  check(options);
  const Eigen::Index models = distances.rows();
  const Diffusion diffusion(nearest_models(models, options.neighbours, rows_of(distances)), options);
  const Eigen::MatrixXd system =
      Eigen::MatrixXd::Identity(models, models) - options.damping * Eigen::MatrixXd(diffusion.graph);
  const Eigen::MatrixXd affinities = positive_definite_inverse(system);
  return symmetric(diffusion.distances_of(affinities, distances, 0));
}

namespace {

/// By model, whether others are among its k nearest.
bool is_near(const NearestModels& nearest, std::int32_t model, std::int32_t other, Eigen::Index k) {
  const auto row = nearest.indices.row(model).head(std::min(k, nearest.indices.cols()));
  return (row.array() == other).any();
}

/// The model and those of its k nearest that have it among theirs, ascending.
std::vector<std::int32_t> reciprocal_neighbours(const NearestModels& nearest, std::int32_t model, Eigen::Index k) {
  std::vector<std::int32_t> mutual = {model};
  for (const std::int32_t other : nearest.indices.row(model).head(std::min(k, nearest.indices.cols()))) {
    if (other >= 0 && is_near(nearest, other, model, k)) mutual.push_back(other);
  }
  std::ranges::sort(mutual);
  return mutual;
}

/// The reciprocal neighbours, and those of half the size of each of them of which two thirds are among them.
std::vector<std::int32_t> expanded_neighbours(const NearestModels& nearest, std::int32_t model, Eigen::Index k) {
  const std::vector<std::int32_t> mutual = reciprocal_neighbours(nearest, model, k);
  std::vector<std::int32_t> expanded = mutual;
  for (const std::int32_t other : mutual) {
    const std::vector<std::int32_t> theirs = reciprocal_neighbours(nearest, other, std::max<Eigen::Index>(k / 2, 1));
    std::vector<std::int32_t> common;
    std::ranges::set_intersection(theirs, mutual, std::back_inserter(common));
    if (3 * common.size() > 2 * theirs.size()) expanded.insert(expanded.end(), theirs.begin(), theirs.end());
  }
  std::ranges::sort(expanded);
  expanded.erase(std::unique(expanded.begin(), expanded.end()), expanded.end());
  return expanded;
}

/// A model's neighbours with Gaussian weights that sum to 1.
SparseRow encoded(const DistanceMatrix& distances, const NearestModels& nearest, std::int32_t model, Eigen::Index k) {
  SparseRow row;
  const double unit = mean_distance(nearest.distances.row(model));
  double total = 0;
  for (const std::int32_t other : expanded_neighbours(nearest, model, k)) {
    const double distance = other == model ? 0 : distances(model, other);
    const double weight = unit > 0 || std::isinf(distance) ? std::exp(-distance / unit) : 1;
    row.emplace_back(other, weight);
    total += weight;
  }
  for (auto& entry : row) entry.second /= total;
  return row;
}

/// The mean of the rows of the model and its nearest neighbours, of `most` rows or as many as there are.
SparseRow mean_row(const std::vector<SparseRow>& rows, const NearestModels& nearest, std::int32_t model,
                   Eigen::Index most) {
  SparseRow sum = rows[static_cast<std::size_t>(model)];
  std::size_t count = 1;
  for (const std::int32_t other : nearest.indices.row(model).head(std::min(most - 1, nearest.indices.cols()))) {
    if (other < 0) break;
    ++count;
    const SparseRow& row = rows[static_cast<std::size_t>(other)];
    sum.insert(sum.end(), row.begin(), row.end());
  }
  std::ranges::sort(sum);
  SparseRow merged;
  for (const auto& [column, weight] : sum) {
    if (merged.empty() || merged.back().first != column) merged.emplace_back(column, 0);
    merged.back().second += weight / static_cast<double>(count);
  }
  return merged;
}

/// 1 - sum of minima / sum of maxima, of one row with all; the rows' columns are given the other way round.
Eigen::RowVectorXd jaccard_distances(const SparseRow& row, const std::vector<SparseRow>& by_column,
                                     const Eigen::RowVectorXd& sums, double own_sum) {
  Eigen::RowVectorXd minima = Eigen::RowVectorXd::Zero(sums.size());
  for (const auto& [column, weight] : row) {
    for (const auto& [other, others_weight] : by_column[static_cast<std::size_t>(column)]) {
      minima[other] += std::min(weight, others_weight);
    }
  }
  return 1 - minima.array() / (sums.array() + own_sum - minima.array());
}

}  // namespace

DistanceMatrix k_reciprocal(const DistanceMatrix& given, const ReciprocalOptions& options) {
  check_options("k_reciprocal", reciprocal_table, options);
  if (options.expansion_neighbours > options.neighbours) {
    throw InputError("k_reciprocal: expansion_neighbours is " + std::to_string(options.expansion_neighbours) +
                     "; it must be at most neighbours, which is " + std::to_string(options.neighbours));
  }
  const Eigen::Index models = given.rows();
  const NearestModels found = nearest_models(models, options.neighbours, rows_of(given));
  if (models < 2) return symmetric(given);
  const double factor = safe_factor(found.largest);
  const NearestModels nearest = multiplied(found, factor);
  const DistanceMatrix distances = factor * given;
  const auto size = static_cast<std::size_t>(models);
  std::vector<SparseRow> codes(size);
  std::vector<SparseRow> means(size);
  const auto of_all = [&](auto compute) {
    parallel_for(std::size_t{0}, size, [&](std::size_t i) { compute(i, static_cast<std::int32_t>(i)); });
  };
  of_all([&](std::size_t i, std::int32_t model) { codes[i] = encoded(distances, nearest, model, options.neighbours); });
  of_all([&](std::size_t i, std::int32_t model) {
    means[i] = mean_row(codes, nearest, model, std::min<Eigen::Index>(options.expansion_neighbours, models));
  });
  Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(models);
  std::vector<SparseRow> by_column(size);
  for (std::size_t i = 0; i < size; ++i) {
    for (const auto& [column, weight] : means[i]) {
      by_column[static_cast<std::size_t>(column)].emplace_back(static_cast<std::int32_t>(i), weight);
      sums[static_cast<Eigen::Index>(i)] += weight;
    }
  }
  const double share = nearest.largest > 0 ? options.original / nearest.largest : 0;
  DistanceMatrix result(models, models);
  of_all([&](std::size_t i, std::int32_t model) {
    const Eigen::RowVectorXd jaccard = jaccard_distances(means[i], by_column, sums, sums[model]);
    result.row(model) = (1 - options.original) * jaccard + share * distances.row(model);
    for (Eigen::Index j = 0; j < models; ++j) {
      if (!std::isinf(distances(model, j))) continue;
      result(model, j) = jaccard[j] < 1 ? (1 - options.original) * jaccard[j] + options.original : infinity;
    }
  });
  return symmetric(result);
}

namespace {

/// Whether a column is infinite in the row and in those of its nearest neighbours.
bool is_far_from_all(const DistanceMatrix& distances, const NearestModels& nearest, Eigen::Index row,
                     Eigen::Index column) {
  const auto is_far = [&](Eigen::Index i) { return i != column && std::isinf(distances(i, column)); };
  return is_far(row) &&
         std::ranges::all_of(nearest.indices.row(row), [&](std::int32_t other) { return other < 0 || is_far(other); });
}

}  // namespace

DistanceMatrix query_expansion(const DistanceMatrix& distances, const ExpansionOptions& options) {
  check_options("query_expansion", expansion_table, options);
  const NearestModels nearest = nearest_models(distances.rows(), options.neighbours, rows_of(distances));
  const double factor = safe_factor(nearest.largest);
  DistanceMatrix finite = distances.array().isInf().select(nearest.largest, distances) * factor;
  finite.diagonal().setZero();
  DistanceMatrix result = finite;
  parallel_for(Eigen::Index{0}, distances.rows(), [&](Eigen::Index i) {
    double total = 1;
    for (Eigen::Index n = 0; n < nearest.indices.cols() && nearest.indices(i, n) >= 0; ++n) {
      const double weight = 1 / static_cast<double>(n + 2);
      result.row(i) += weight * finite.row(nearest.indices(i, n));
      total += weight;
    }
    result.row(i) /= total * factor;
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      const bool far = is_far_from_all(distances, nearest, i, j);
      result(i, j) = far ? infinity : std::min(result(i, j), std::numeric_limits<double>::max());
    }
  });
  return symmetric(result);
}

std::span<const RerankMethod> rerank_methods() {
  static constexpr std::array methods{
      RerankMethod{"diffusion", "Walks from model to near model.", diffusion_parameters,
                   [](const DistanceMatrix& distances, const ParameterValues& values) {
                     return diffused(distances, diffusion_options(values));
                   }},
      RerankMethod{"k_reciprocal", "Sets of models that are near each other.", reciprocal_parameters,
                   [](const DistanceMatrix& distances, const ParameterValues& values) {
                     return k_reciprocal(distances, options_from(reciprocal_table, values));
                   }},
      RerankMethod{"query_expansion", "Means with the nearest models' distances.", expansion_parameters,
                   [](const DistanceMatrix& distances, const ParameterValues& values) {
                     return query_expansion(distances, options_from(expansion_table, values));
                   }}};
  return methods;
}

const RerankMethod& rerank_method(std::string_view name) {
  const auto methods = rerank_methods();
  const auto found = std::ranges::find(methods, name, &RerankMethod::name);
  if (found != methods.end()) return *found;
  std::string message = "there is no way to re-rank named \"" + std::string(name) + "\"; known are:";
  for (const RerankMethod& one : methods) message.append(" ").append(one.name);
  throw InputError(message);
}

DiffusionOptions diffusion_options(const ParameterValues& values) { return options_from(diffusion_table, values); }

}  // namespace shapegauge
