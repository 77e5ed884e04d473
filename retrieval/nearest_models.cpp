// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/nearest_models.h"

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

RowSource rows_of(const DistanceMatrix& distances) {
  if (distances.rows() != distances.cols()) {
    throw ArgumentError("only square distance matrices can be re-ranked, not " + std::to_string(distances.rows()) +
                        " x " + std::to_string(distances.cols()));
  }
  return [&distances](Eigen::Index first, Eigen::Index count) -> DistanceMatrix {
    return distances.middleRows(first, count);
  };
}

void check_distances(const DistanceMatrix& rows, Eigen::Index first, const std::string& of) {
  if (rows.size() == 0 || rows.minCoeff<Eigen::PropagateNaN>() >= 0) return;
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    for (Eigen::Index column = 0; column < rows.cols(); ++column) {
      const double distance = rows(row, column);
      if (distance >= 0) continue;
      throw ArgumentError("distances between models must be non-negative numbers; that in row " +
                          std::to_string(first + row) + ", column " + std::to_string(column) + of +
                          " (counted from 0) is " + (std::isnan(distance) ? "not a number" : "negative"));
    }
  }
}

NearestModels nearest_models(Eigen::Index models, int k, const RowSource& rows) {
  if (k < 1) throw ArgumentError("the number of nearest neighbours must be at least 1, not " + std::to_string(k));
  const Eigen::Index count = std::clamp<Eigen::Index>(models - 1, 0, k);
  NearestModels nearest{{models, count}, {models, count}};
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(models);
  for_each_block(models, rows, [&](Eigen::Index first, const DistanceMatrix& block) {
    check_distances(block, first);
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

NearestModels with_scaled_distances(NearestModels nearest, double factor) {
  if (factor == 1) return nearest;
  nearest.distances *= factor;
  nearest.largest *= factor;
  return nearest;
}

double overflow_safe_factor(double largest) {
  if (largest > 0x1p960) return 0x1p-64;
  return largest > 0 && largest < 0x1p-960 ? 0x1p512 : 1;
}

double overflow_safe_mean(std::span<const double> distances) {
  if (distances.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto count = static_cast<double>(distances.size());
  const double mean = std::accumulate(distances.begin(), distances.end(), 0.0,
                                      [&](double sum, double distance) { return sum + distance / count; });
  return std::min(mean, std::numeric_limits<double>::max());
}

DistanceMatrix symmetrise(const DistanceMatrix& distances) {
  DistanceMatrix result = distances / 2 + distances.transpose() / 2;
  result.diagonal().setZero();
  return result;
}

}  // namespace shapegauge
