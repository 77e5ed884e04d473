// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/collection_sum.h"

#include <cstddef>
#include <limits>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

namespace {

std::span<const double> span_of(const Eigen::RowVectorXd& row) {
  return {row.data(), static_cast<std::size_t>(row.size())};
}

/// Computes the local scales of a term's models; appends the nearest models, found in the same pass.
LocalScales local_scales_of(Eigen::Index models, const RowSource& rows, std::vector<NearestModels>& nearest) {
  Eigen::VectorXd means(models);
  const RowSource measured = [&](Eigen::Index first, Eigen::Index count) {
    DistanceMatrix block = rows(first, count);
    parallel_for(Eigen::Index{0}, block.rows(), [&](Eigen::Index i) {
      means[first + i] = mean_distance_to_nearest(span_of(block.row(i)), first + i);
    });
    return block;
  };
  nearest.push_back(nearest_models(models, nearest_for_weights(), measured));
  return LocalScales::of_means(means);
}

/// Computes distances_at_ranks() of a term's models, after local scaling.
DistanceMatrix scaled_at_ranks(Eigen::Index models, const RowSource& rows, const LocalScales& scales) {
  DistanceMatrix at_ranks(models, sampled_rank_count(models));
  for_each_block(models, rows, [&](Eigen::Index first, const DistanceMatrix& block) {
    parallel_for(Eigen::Index{0}, block.rows(), [&](Eigen::Index i) {
      const Eigen::Index model = first + i;
      at_ranks.row(model) = distances_at_ranks(span_of(scales.scaled(block.row(i), scales.roots[model])), model);
    });
  });
  return at_ranks;
}

double unit_of(Eigen::Index models, const RowSource& rows, DistanceScale scale, std::size_t term) {
  if (scale == DistanceScale::none) return 1;
  const double unit = distance_unit(rows(0, models), scale);
  if (unit > 0) return unit;
  throw ArgumentError("the median or mean of the distances of term " + std::to_string(term) +
                      " (counted from 0) is 0; use another scale");
}

}  // namespace

CollectionSum collection_sum(Eigen::Index models, std::span<const RowSource> terms, std::span<const double> weights,
                             SumWeights kind, DistanceScale scale) {
  check_sum_weights(terms.size(), weights);
  CollectionSum sum;
  sum.scale = scale;
  sum.weights.assign(weights.begin(), weights.end());
  const bool local = uses_local_scales(scale);
  std::vector<NearestModels> nearest;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    sum.units.push_back(local || weights[k] == 0 ? 1 : unit_of(models, terms[k], scale, k));
    sum.local_scales.emplace_back();
    sum.at_ranks.emplace_back();
    if (weights[k] == 0) {
      nearest.emplace_back();
    } else if (local) {
      sum.local_scales[k] = local_scales_of(models, terms[k], nearest);
      if (uses_ranks(scale)) sum.at_ranks[k] = scaled_at_ranks(models, terms[k], sum.local_scales[k]);
    } else if (kind == SumWeights::agreement) {
      nearest.push_back(nearest_models(models, nearest_for_weights(), terms[k]));
    }
  }
  if (kind == SumWeights::agreement) sum.weights = sum_weights(nearest, weights);
  return sum;
}

Eigen::VectorXd sum_row(const CollectionSum& sum, std::span<const Eigen::VectorXd> distances, Eigen::Index member) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(distances.front().size());
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const double weight = sum.weights[k];
    if (weight == 0) continue;
    const Eigen::RowVectorXd of_term = distances[k].transpose();
    if (!uses_local_scales(sum.scale)) {
      row += weight / sum.units[k] * of_term;
      continue;
    }
    const LocalScales& scales = sum.local_scales[k];
    const double root = member >= 0 ? scales.roots[member] : scales.root_of(mean_distance_to_nearest(span_of(of_term)));
    const Eigen::RowVectorXd scaled = scales.scaled(of_term, root);
    if (sum.scale == DistanceScale::local) {
      row += weight * scaled;
      continue;
    }
    const DistanceMatrix& at_ranks = sum.at_ranks[k];
    const Eigen::RowVectorXd model_at_ranks = member >= 0 ? at_ranks.row(member) : distances_at_ranks(span_of(scaled));
    row += weight * log_mutual_ranks(span_of(scaled), model_at_ranks, at_ranks);
  }
  return row.cwiseMin(std::numeric_limits<double>::max()).transpose();
}

}  // namespace shapegauge
