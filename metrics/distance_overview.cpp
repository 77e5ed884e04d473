// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/distance_overview.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

namespace {

constexpr Eigen::Index max_nearest = 10;
constexpr double no_distance = std::numeric_limits<double>::infinity();

/// Returns the unit of sums: below the 16-bit resolution of the heat map, and large enough to prevent overflow.
double unit_for(double largest) {
  constexpr int bits = 24;
  return std::ldexp(1.0, (largest > 0 ? std::ilogb(largest) : 0) - bits);
}

/// Converts a distance to units; disproportionate values are clamped.
std::int64_t in_units(double distance, double unit) {
  constexpr double most = 0x1p35;
  return std::llround(std::clamp(distance / unit, -most, most));
}

void add_to_sums(std::span<const double> row, Eigen::Index model, OverviewAccumulator& seen) {
  const Eigen::Index block = seen.overview.block;
  const Eigen::Index cell_row = seen.positions[static_cast<std::size_t>(model)] / block;
  OverviewAccumulator::Cell* const cells = seen.sums.data() + cell_row * seen.overview.cells.cols();
  for (std::size_t other = 0; other < row.size(); ++other) {
    const double distance = static_cast<Eigen::Index>(other) == model ? 0 : row[other];
    if (!std::isfinite(distance)) continue;
    OverviewAccumulator::Cell& cell = cells[seen.positions[other] / block];
    cell.sum += in_units(distance, seen.unit);
    ++cell.count;
  }
}

/// Groups rows by the cells that they add to, which must not be updated concurrently.
std::vector<std::vector<Eigen::Index>> rows_by_cell(Eigen::Index first, Eigen::Index count,
                                                    const OverviewAccumulator& seen) {
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(count));
  std::iota(rows.begin(), rows.end(), Eigen::Index{0});
  const auto cell = [&](Eigen::Index row) {
    return seen.positions[static_cast<std::size_t>(first + row)] / seen.overview.block;
  };
  std::ranges::stable_sort(rows, {}, cell);
  std::vector<std::vector<Eigen::Index>> groups;
  for (const Eigen::Index row : rows) {
    if (groups.empty() || cell(groups.back().front()) != cell(row)) groups.emplace_back();
    groups.back().push_back(row);
  }
  return groups;
}

std::span<const double> row_of(const DistanceTable& rows, Eigen::Index i) {
  return {rows.row(i).data(), static_cast<std::size_t>(rows.cols())};
}

}  // namespace

std::vector<Eigen::Index> order_by_class(std::span<const int> labels) {
  std::vector<Eigen::Index> order(labels.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Eigen::Index model) { return labels[static_cast<std::size_t>(model)]; });
  return order;
}

double largest_finite(std::span<const double> row, Eigen::Index itself) {
  double largest = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (std::isfinite(row[i]) && static_cast<Eigen::Index>(i) != itself) largest = std::max(largest, std::abs(row[i]));
  }
  return largest;
}

OverviewAccumulator begin_overview(std::span<const int> labels, double largest) {
  OverviewAccumulator seen;
  DistanceOverview& overview = seen.overview;
  const auto models = static_cast<Eigen::Index>(labels.size());
  overview.block = std::max<Eigen::Index>(1, (models + max_heat_map_side - 1) / max_heat_map_side);
  const Eigen::Index side = (models + overview.block - 1) / overview.block;
  overview.cells.resize(side, side);
  seen.unit = unit_for(largest);
  if (overview.block > 1) seen.sums.resize(static_cast<std::size_t>(side * side));
  seen.positions.resize(labels.size());
  const std::vector<Eigen::Index> order = order_by_class(labels);
  for (std::size_t position = 0; position < order.size(); ++position) {
    seen.positions[static_cast<std::size_t>(order[position])] = static_cast<std::int32_t>(position);
  }
  const Eigen::Index nearest_count = std::clamp<Eigen::Index>(models - 1, 0, max_nearest);
  overview.nearest.resize(models, nearest_count);
  overview.nearest_distances.resize(models, nearest_count);
  return seen;
}

void accumulate(const DistanceTable& rows, Eigen::Index first, OverviewAccumulator& seen) {
  DistanceOverview& overview = seen.overview;
  const Eigen::Index nearest_count = overview.nearest.cols();
  parallel_for(Eigen::Index{0}, rows.rows(), [&](Eigen::Index i) {
    const Eigen::Index model = first + i;
    const std::vector<Eigen::Index> nearest = first_ranked(row_of(rows, i), model, nearest_count);
    for (Eigen::Index k = 0; k < nearest_count; ++k) {
      const Eigen::Index other = nearest[static_cast<std::size_t>(k)];
      overview.nearest(model, k) = static_cast<std::int32_t>(other);
      overview.nearest_distances(model, k) = rows(i, other);
    }
    if (overview.block > 1) return;
    const std::int32_t row = seen.positions[static_cast<std::size_t>(model)];
    for (Eigen::Index other = 0; other < rows.cols(); ++other) {
      double& cell = overview.cells(row, seen.positions[static_cast<std::size_t>(other)]);
      cell = other == model ? 0 : rows(i, other);
      if (!std::isfinite(cell)) cell = no_distance;
    }
  });
  if (overview.block == 1) return;
  const std::vector<std::vector<Eigen::Index>> groups = rows_by_cell(first, rows.rows(), seen);
  parallel_for(std::size_t{0}, groups.size(), [&](std::size_t group) {
    for (const Eigen::Index i : groups[group]) add_to_sums(row_of(rows, i), first + i, seen);
  });
}

DistanceOverview overview_of(OverviewAccumulator seen) {
  Eigen::MatrixXd& cells = seen.overview.cells;
  for (std::size_t i = 0; i < seen.sums.size(); ++i) {
    const auto& [sum, count] = seen.sums[i];
    cells(static_cast<Eigen::Index>(i) / cells.cols(), static_cast<Eigen::Index>(i) % cells.cols()) =
        count > 0 ? static_cast<double>(sum) / static_cast<double>(count) * seen.unit : no_distance;
  }
  return std::move(seen.overview);
}

DistanceOverview overview_of(const DistanceTable& distances, std::span<const int> labels) {
  OverviewAccumulator seen = begin_overview(labels, largest_finite(row_of(distances, 0), 0));
  accumulate(distances, 0, seen);
  return overview_of(std::move(seen));
}

}  // namespace shapegauge
