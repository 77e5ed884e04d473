#include "shapegauge/retrieval/collection_sum.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

namespace {

/// What one pass over the distances of a term finds.
struct TermPass {
  NearestModels nearest;
  Eigen::VectorXd means;  ///< mean_distance_to_nearest(), by model
};

TermPass pass_over(Eigen::Index models, const RowSource& rows) {
  TermPass found;
  found.means.resize(models);
  const RowSource measured = [&](Eigen::Index first, Eigen::Index count) {
    DistanceMatrix block = rows(first, count);
    parallel_for(Eigen::Index{0}, block.rows(), [&](Eigen::Index i) {
      found.means[first + i] =
          mean_distance_to_nearest({block.row(i).data(), static_cast<std::size_t>(block.cols())}, first + i);
    });
    return block;
  };
  found.nearest = nearest_models(models, nearest_for_weights(), measured);
  return found;
}

double unit_of(Eigen::Index models, const RowSource& rows, DistanceScale scale, std::size_t term) {
  if (scale == DistanceScale::none) return 1;
  const double unit = distance_unit(rows(0, models), scale);
  if (unit > 0) return unit;
  throw ArgumentError("the median or mean of the distances of term " + std::to_string(term) +
                      " (counted from 0) is 0: it cannot be divided by it");
}

}  // namespace

CollectionSum collection_sum(Eigen::Index models, std::span<const RowSource> terms, std::span<const double> weights,
                             SumWeights kind, DistanceScale scale) {
  check_sum_weights(terms.size(), weights);
  CollectionSum sum{.scale = scale, .weights = {weights.begin(), weights.end()}, .units = {}, .local_scales = {}};
  const bool local = scale == DistanceScale::local;
  std::vector<NearestModels> nearest(terms.size());
  if (local) sum.local_scales.resize(terms.size());
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (!local) sum.units.push_back(weights[k] > 0 ? unit_of(models, terms[k], scale, k) : 1);
    if (weights[k] == 0 || (!local && kind == SumWeights::given)) continue;
    TermPass found = pass_over(models, terms[k]);
    nearest[k] = std::move(found.nearest);
    if (local) sum.local_scales[k] = LocalScales::of_means(found.means);
  }
  if (kind == SumWeights::agreement) sum.weights = sum_weights(nearest, weights);
  return sum;
}

Eigen::VectorXd sum_row(const CollectionSum& sum, std::span<const Eigen::VectorXd> distances, Eigen::Index member) {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(distances.front().size());
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const double weight = sum.weights[k];
    if (weight == 0) continue;
    if (sum.scale != DistanceScale::local) {
      row += weight / sum.units[k] * distances[k];
      continue;
    }
    const LocalScales& scales = sum.local_scales[k];
    const double root = member >= 0 ? scales.roots[member]
                                    : scales.root_of(mean_distance_to_nearest(
                                          {distances[k].data(), static_cast<std::size_t>(distances[k].size())}));
    row.array() += weight * (distances[k].array() / (root * scales.roots.array()));
  }
  return row.cwiseMin(std::numeric_limits<double>::max());
}

}  // namespace shapegauge
