// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <limits>
#include <tbb/global_control.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/method_standings.h"
#include "shapegauge/metrics/significance_tests.h"
#include "tests/metrics/simulated_methods.h"

namespace shapegauge {

namespace {

/// Twenty classes of two queries; each method has one value, with small differences between queries.
Eigen::MatrixXd steady_methods(const std::vector<double>& values) {
  Eigen::MatrixXd table(40, static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index query = 0; query < 40; ++query) {
    for (Eigen::Index method = 0; method < table.cols(); ++method) {
      table(query, method) = values[static_cast<std::size_t>(method)] + 0.01 * ((query * 7 + method * 3) % 5 - 2);
    }
  }
  return table;
}

std::vector<int> pairs_of_queries() {
  std::vector<int> classes;
  for (int query = 0; query < 40; ++query) classes.push_back(query / 2);
  return classes;
}

/// Six methods with increasing differences, over 30 classes.
SimulatedMethods spread_methods() {
  SimulatedMethods methods = simulated_methods(30, 5, 1);
  methods.per_query.conservativeResize(Eigen::NoChange, 6);
  for (unsigned pair = 1; pair < 3; ++pair) {
    const Eigen::MatrixXd more = simulated_methods(30, 5, 1 + pair).per_query;
    methods.per_query.middleCols(2 * pair, 2) = more.array() - 0.05 * pair;
  }
  return methods;
}

TEST(MethodStandings, RankByAverageAndGroupBySignificance) {
  const auto standings = standings_of(steady_methods({0.3, 0.9, 0.3, 0.6}), pairs_of_queries());
  EXPECT_EQ(standings[1].rank, 1U);
  EXPECT_EQ(standings[3].rank, 2U);
  EXPECT_NEAR(standings[1].average, 0.9, 0.01);
  EXPECT_EQ(standings[1].letters, "a");
  EXPECT_EQ(standings[3].letters, "b");
  EXPECT_EQ(standings[0].letters, "c");
  EXPECT_EQ(standings[2].letters, "c");
  // The two equal methods may be third or fourth; the order of the others is fixed.
  EXPECT_EQ(standings[0].best_rank, 3U);
  EXPECT_EQ(standings[0].worst_rank, 4U);
  EXPECT_EQ(standings[1].best_rank, 1U);
  EXPECT_EQ(standings[1].worst_rank, 1U);
}

TEST(MethodStandings, HaveRanksButNoIntervalsIfSignificanceIsNotTested) {
  const auto standings = standings_of(steady_methods({0.3, 0.9}), pairs_of_queries(), {.tested = false});
  EXPECT_EQ(standings[0].rank, 2U);
  EXPECT_EQ(standings[0].best_rank, 1U);
  EXPECT_FALSE(standings[0].interval);
}

TEST(MethodStandings, GiveMethodsOfEqualAverageTheSameRank) {
  Eigen::MatrixXd table = steady_methods({0.5, 0.2, 0.5, 0.1});
  table.col(2) = table.col(0);
  const auto standings = standings_of(table, pairs_of_queries());
  EXPECT_EQ(standings[0].rank, 1U);
  EXPECT_EQ(standings[2].rank, 1U);
  EXPECT_EQ(standings[1].rank, 3U);
  EXPECT_EQ(standings[3].rank, 4U);
}

TEST(MethodStandings, ShareLettersExactlyIfTheTestFindsNoDifference) {
  const SimulatedMethods methods = spread_methods();
  const StandingOptions options{};
  const auto standings = standings_of(methods.per_query, methods.classes, options);
  const UnitValues units = unit_values_of(methods.per_query, methods.classes, options.blocks, options.average);
  const Eigen::MatrixXd p = tukey_hsd_p_values(units, options.resampling);
  const auto intervals = bootstrap_intervals(units, options.confidence, options.resampling);
  for (std::size_t a = 0; a < standings.size(); ++a) {
    EXPECT_EQ(standings[a].interval->low, intervals[a].low);
    EXPECT_EQ(standings[a].interval->high, intervals[a].high);
    std::size_t better = 0;
    std::size_t worse = 0;
    for (std::size_t b = 0; b < standings.size(); ++b) {
      const bool differ = p(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) <= 0.05;
      better += differ && standings[b].average > standings[a].average ? 1 : 0;
      worse += differ && standings[b].average < standings[a].average ? 1 : 0;
    }
    EXPECT_EQ(standings[a].best_rank, better + 1) << a;
    EXPECT_EQ(standings[a].worst_rank, standings.size() - worse) << a;
  }
  // A p-value of 0.1 at the level 0.1.
  const auto at_level =
      standings_of(steady_methods({0.3, 0.9}), pairs_of_queries(), {.confidence = 0.9, .resampling = {.resamples = 9}});
  EXPECT_EQ(at_level[1].worst_rank, 1U);
}

TEST(MethodStandings, ReportNoDifferencesForOneClassOrOneMethod) {
  const auto one_class =
      standings_of(steady_methods({0.9, 0.1}), std::vector<int>(40, 3), {.blocks = ResamplingUnit::classes});
  EXPECT_FALSE(one_class[0].interval);
  EXPECT_EQ(one_class[0].letters, one_class[1].letters);
  EXPECT_EQ(one_class[1].rank, 2U);
  const auto one_method = standings_of(steady_methods({0.9}), pairs_of_queries());
  EXPECT_EQ(one_method[0].letters, "a");
  EXPECT_TRUE(one_method[0].interval);
}

TEST(MethodStandings, RejectEmptyTablesAndNonFiniteScores) {
  EXPECT_THROW(standings_of(Eigen::MatrixXd(40, 0), pairs_of_queries()), ArgumentError);
  Eigen::MatrixXd table = steady_methods({0.5, 0.2});
  table(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(standings_of(table, pairs_of_queries()), ArgumentError);
}

TEST(MethodStandings, AreTheSameForAnyNumberOfThreads) {
  const SimulatedMethods methods = spread_methods();
  const auto letters = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::string text;
    for (const MethodStanding& one : standings_of(methods.per_query, methods.classes)) {
      text += one.letters + std::to_string(one.interval->low) + " ";
    }
    return text;
  };
  EXPECT_EQ(letters(1), letters(2));
}

}  // namespace

}  // namespace shapegauge
