#include "shapegauge/experiments/report/heat_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tbb/parallel_for.h>
#include <vector>

#include "shapegauge/experiments/report/packed_values.h"

namespace shapegauge {

namespace {

/// The mean of the finite distances between two groups of models; infinity where there are none.
double mean_distance(const DistanceTable& distances, std::span<const Eigen::Index> rows,
                     std::span<const Eigen::Index> columns) {
  double sum = 0;
  std::size_t count = 0;
  for (const Eigen::Index row : rows) {
    for (const Eigen::Index column : columns) {
      const double distance = row == column ? 0 : distances(row, column);
      if (!std::isfinite(distance)) continue;
      sum += distance;
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<Eigen::Index> order_by_class(std::span<const int> labels) {
  std::vector<Eigen::Index> order(labels.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Eigen::Index model) { return labels[static_cast<std::size_t>(model)]; });
  return order;
}

nlohmann::ordered_json heat_map(const DistanceTable& distances, std::span<const int> labels) {
  const std::vector<Eigen::Index> order = order_by_class(labels);
  const Eigen::Index block = (distances.rows() + largest_heat_map - 1) / largest_heat_map;
  const Eigen::Index side = (distances.rows() + block - 1) / block;
  const auto models_of = [&](Eigen::Index cell) {
    const auto begin = static_cast<std::size_t>(cell * block);
    return std::span(order).subspan(begin, std::min(static_cast<std::size_t>(block), order.size() - begin));
  };
  Eigen::MatrixXd cells(side, side);
  tbb::parallel_for(Eigen::Index{0}, side, [&](Eigen::Index row) {
    for (Eigen::Index column = 0; column < side; ++column) {
      cells(row, column) = mean_distance(distances, models_of(row), models_of(column));
    }
  });
  const bool symmetric = cells == cells.transpose();
  std::vector<double> values;
  for (Eigen::Index row = 0; row < side; ++row) {
    for (Eigen::Index column = symmetric ? row : 0; column < side; ++column) values.push_back(cells(row, column));
  }
  nlohmann::ordered_json json{{"side", side}, {"block", block}, {"symmetric", symmetric}};
  json.update(packed(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))));
  return json;
}

}  // namespace shapegauge
