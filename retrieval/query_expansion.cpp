#include "shapegauge/retrieval/query_expansion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::array expansion_table = {
    option_of<&ExpansionOptions::neighbours>("neighbours", {.low = 1, .high = 1000},
                                             "Nearest models whose rows are added to a model's own."),
};
constexpr auto expansion_parameters = parameters_of(expansion_table);

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

RerankMethod query_expansion_method() {
  return {"query_expansion", "Means with the nearest models' distances.", expansion_parameters,
          [](const DistanceMatrix& distances, const ParameterValues& values) {
            return query_expansion(distances, options_from(expansion_table, values));
          }};
}

}  // namespace shapegauge
