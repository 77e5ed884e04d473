// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/method_standings.h"

#include <algorithm>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/equal_scores.h"
#include "shapegauge/metrics/homogeneous_groups.h"
#include "shapegauge/metrics/significance_tests.h"

namespace shapegauge {

namespace {

Eigen::MatrixXd p_values_of(const UnitValues& units, const StandingOptions& options) {
  if (!options.tested || units.values.rows() < 2) {
    return Eigen::MatrixXd::Ones(units.values.cols(), units.values.cols());
  }
  return tukey_hsd_p_values(units, options.resampling);
}

}  // namespace

std::vector<MethodStanding> standings_of(const Eigen::MatrixXd& per_query, std::span<const int> classes,
                                         const StandingOptions& options) {
  if (per_query.cols() == 0) throw ArgumentError("a ranking needs at least one method, and there is none");
  if (!per_query.allFinite()) throw ArgumentError("scores to rank by must be finite numbers");
  const UnitValues units = unit_values_of(per_query, classes, options.blocks, options.average);
  const Eigen::VectorXd averages = averages_of(units);
  const Eigen::MatrixXd p_values = p_values_of(units, options);
  const std::vector<std::vector<std::size_t>> equal = groups_of_equal_scores(averages);
  std::vector<std::size_t> order;
  for (const std::vector<std::size_t>& group : equal) order.insert(order.end(), group.begin(), group.end());
  const std::size_t methods = order.size();
  const double alpha = significance_level(options.confidence);
  const auto differ = [&](std::size_t i, std::size_t j) {
    return p_values(static_cast<Eigen::Index>(order[i]), static_cast<Eigen::Index>(order[j])) <= alpha;
  };
  const std::vector<HomogeneousGroup> groups = homogeneous_groups(methods, differ);
  const std::vector<std::string> letters = compact_letters(methods, groups);

  std::vector<MethodStanding> standings(methods);
  for (std::size_t i = 0; i < methods; ++i) {
    MethodStanding& standing = standings[order[i]];
    standing.average = averages[static_cast<Eigen::Index>(order[i])];
    // Methods that do not differ are consecutive in the order.
    const auto holds = [&](const HomogeneousGroup& group) { return group.first <= i && i <= group.last; };
    standing.best_rank = std::ranges::find_if(groups, holds)->first + 1;
    standing.worst_rank = std::find_if(groups.rbegin(), groups.rend(), holds)->last + 1;
    standing.letters = letters[i];
  }
  std::size_t better = 0;
  for (const std::vector<std::size_t>& group : equal) {
    for (const std::size_t method : group) standings[method].rank = better + 1;
    better += group.size();
  }
  if (!options.tested || units.values.rows() < 2) return standings;
  const std::vector<ConfidenceInterval> intervals = bootstrap_intervals(units, options.confidence, options.resampling);
  for (std::size_t i = 0; i < methods; ++i) standings[i].interval = intervals[i];
  return standings;
}

}  // namespace shapegauge
