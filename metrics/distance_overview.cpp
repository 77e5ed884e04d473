#include "shapegauge/metrics/distance_overview.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

namespace {

constexpr Eigen::Index nearest_kept = 10;

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

void add_to_sums(std::span<const double> row, Eigen::Index model, PartialOverview& seen) {
  const std::int32_t cell_row = seen.positions[static_cast<std::size_t>(model)] / static_cast<std::int32_t>(seen.block);
  PartialOverview::Cell* const cells = seen.sums.data() + cell_row * seen.side;
  for (std::size_t other = 0; other < row.size(); ++other) {
    const double distance = static_cast<Eigen::Index>(other) == model ? 0 : row[other];
    if (!std::isfinite(distance)) continue;
    PartialOverview::Cell& cell = cells[seen.positions[other] / seen.block];
    cell.sum += in_units(distance, seen.unit);
    ++cell.count;
  }
}

/// Groups rows by the cells that they add to, which must not be updated concurrently.
std::vector<std::vector<Eigen::Index>> rows_by_cell(Eigen::Index first, Eigen::Index count,
                                                    const PartialOverview& seen) {
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(count));
  std::iota(rows.begin(), rows.end(), Eigen::Index{0});
  const auto cell = [&](Eigen::Index row) {
    return seen.positions[static_cast<std::size_t>(first + row)] / seen.block;
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

PartialOverview begin_overview(std::span<const int> labels, double largest, Eigen::Index first, Eigen::Index last) {
  PartialOverview seen;
  const auto models = static_cast<Eigen::Index>(labels.size());
  seen.first = first;
  seen.unit = unit_for(largest);
  seen.block = std::max<Eigen::Index>(1, (models + largest_heat_map - 1) / largest_heat_map);
  seen.side = (models + seen.block - 1) / seen.block;
  seen.positions.resize(labels.size());
  const std::vector<Eigen::Index> order = order_by_class(labels);
  for (std::size_t position = 0; position < order.size(); ++position) {
    seen.positions[static_cast<std::size_t>(order[position])] = static_cast<std::int32_t>(position);
  }
  if (seen.block > 1) {
    seen.sums.resize(static_cast<std::size_t>(seen.side * seen.side));
  } else {
    seen.entries.resize(static_cast<std::size_t>((last - first) * models));
  }
  const Eigen::Index kept = std::clamp<Eigen::Index>(models - 1, 0, nearest_kept);
  seen.nearest.resize(last - first, kept);
  seen.nearest_distances.resize(last - first, kept);
  return seen;
}

void accumulate(const DistanceTable& rows, Eigen::Index first, PartialOverview& seen) {
  const Eigen::Index kept = seen.nearest.cols();
  parallel_for(Eigen::Index{0}, rows.rows(), [&](Eigen::Index i) {
    const std::vector<Eigen::Index> nearest = first_ranked(row_of(rows, i), first + i, kept);
    const Eigen::Index to = first - seen.first + i;
    for (Eigen::Index k = 0; k < kept; ++k) {
      const Eigen::Index other = nearest[static_cast<std::size_t>(k)];
      seen.nearest(to, k) = static_cast<std::int32_t>(other);
      seen.nearest_distances(to, k) = rows(i, other);
    }
    if (seen.block == 1) std::ranges::copy(row_of(rows, i), seen.entries.data() + to * rows.cols());
  });
  if (seen.block == 1) return;
  const std::vector<std::vector<Eigen::Index>> groups = rows_by_cell(first, rows.rows(), seen);
  parallel_for(std::size_t{0}, groups.size(), [&](std::size_t group) {
    for (const Eigen::Index i : groups[group]) add_to_sums(row_of(rows, i), first + i, seen);
  });
}

DistanceOverview overview_of(std::span<const PartialOverview> parts) {
  const PartialOverview& any = parts.front();
  const auto models = static_cast<Eigen::Index>(any.positions.size());
  DistanceOverview overview;
  overview.block = any.block;
  overview.cells.resize(any.side, any.side);
  overview.nearest.resize(models, any.nearest.cols());
  overview.nearest_distances.resize(models, any.nearest.cols());
  std::vector<PartialOverview::Cell> sums(any.sums.size());
  for (const PartialOverview& part : parts) {
    overview.nearest.middleRows(part.first, part.nearest.rows()) = part.nearest;
    overview.nearest_distances.middleRows(part.first, part.nearest.rows()) = part.nearest_distances;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].sum += part.sums[i].sum;
      sums[i].count += part.sums[i].count;
    }
    for (std::size_t i = 0; i < part.entries.size(); ++i) {
      const auto row = part.first + static_cast<Eigen::Index>(i) / models;
      const auto column = static_cast<Eigen::Index>(i) % models;
      const double entry = row == column ? 0 : part.entries[i];
      overview.cells(any.positions[static_cast<std::size_t>(row)], any.positions[static_cast<std::size_t>(column)]) =
          std::isfinite(entry) ? entry : std::numeric_limits<double>::infinity();
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i) / any.side;
    const auto column = static_cast<Eigen::Index>(i) % any.side;
    overview.cells(row, column) = sums[i].count > 0
                                      ? static_cast<double>(sums[i].sum) / static_cast<double>(sums[i].count) * any.unit
                                      : std::numeric_limits<double>::infinity();
  }
  return overview;
}

DistanceOverview overview_of(const DistanceTable& distances, std::span<const int> labels) {
  std::vector<PartialOverview> all;
  all.push_back(begin_overview(labels, largest_finite(row_of(distances, 0), 0), 0, distances.rows()));
  accumulate(distances, 0, all.back());
  return overview_of(all);
}

}  // namespace shapegauge
