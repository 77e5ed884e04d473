// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/metrics/measures.h"
#include "shapegauge/metrics/precision_recall.h"
#include "shapegauge/metrics/ranked_list.h"
#include "tests/metrics/list_of_hits.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(FirstRanked, SortsByDistanceAndThenByIndex) {
  EXPECT_THAT(first_ranked(std::vector<double>{0, 3, 1, 2, 1, 3}, 0, 9), ElementsAre(2, 4, 3, 1, 5));
}

TEST(FirstRanked, HasAtMostTheRequestedNumberOfModels) {
  EXPECT_THAT(first_ranked(std::vector<double>{0, 3, 1, 2, 1, 3}, 0, 3), ElementsAre(2, 4, 3));
  EXPECT_THAT(first_ranked(std::vector<double>{0}, 0, 3), ElementsAre());
}

TEST(FirstRanked, RemovesTheQueryByItsIndexAndNotByItsDistance) {
  EXPECT_THAT(first_ranked(std::vector<double>{0, 0, 7, 1}, 2, 9), ElementsAre(0, 1, 3));
  EXPECT_THAT(first_ranked(std::vector<double>{0, 0, 7, 1}, 1, 9), ElementsAre(0, 3, 2));
}

TEST(FirstRanked, RanksInfinityLastAndMinusInfinityFirst) {
  EXPECT_THAT(first_ranked(std::vector<double>{0, infinity, 1e308, -infinity, infinity}, 0, 9),
              ElementsAre(3, 2, 1, 4));
}

TEST(FirstRanked, TreatsNegativeAndPositiveZeroAsEqual) {
  EXPECT_THAT(first_ranked(std::vector<double>{9, 0.0, -0.0, 0.0}, 0, 9), ElementsAre(1, 2, 3));
}

// The list of the query 2.
template <typename Answer>
RankedList list_of(const std::vector<Answer>& answer, const RetrievalTask& task,
                   const ListConventions& conventions = {.protocol = Protocol::psb, .ties = Ties::index}) {
  return ranked_list(std::span<const Answer>(answer), Relevance(task), 2, conventions);
}

RankedList ranked(const std::vector<double>& row, const std::vector<int>& alternating, Protocol protocol,
                  Ties ties = Ties::index) {
  return list_of(row, leave_one_out(alternating), {.protocol = protocol, .ties = ties});
}

const std::vector<int> alternating = {5, 8, 5, 8, 5};

TEST(RankedList, ExcludesTheQueryUnderThePsbProtocol) {
  const RankedList list = ranked({0, 1, 2, 3, 4}, alternating, Protocol::psb);
  EXPECT_THAT(list.runs, ElementsAre(RankRun{1, 1}, RankRun{2, 0}, RankRun{1, 1}));
  EXPECT_EQ(list.length, 4U);
  EXPECT_EQ(list.relevant, 2U);
  EXPECT_FALSE(list.starts_with_query);
  EXPECT_FALSE(list.tied);
  EXPECT_THAT(list.precision_at_hit, ElementsAre(1, 0.5));
}

TEST(RankedList, BeginsWithTheQueryAtAnyDistanceUnderThePaperProtocol) {
  const RankedList list = ranked({0, 1, infinity, 3, 4}, alternating, Protocol::paper);
  EXPECT_THAT(list.runs, ElementsAre(RankRun{2, 2}, RankRun{2, 0}, RankRun{1, 1}));
  EXPECT_EQ(list.relevant, 3U);
  EXPECT_TRUE(list.starts_with_query);
}

TEST(RankedList, OrdersDistancesOfAnyScale) {
  const std::vector<double> distances{1e308, -infinity, 5,    1e-320, 0,        -1e308, infinity, 5,   -0.0,
                                      2,     1e-320,    -3.5, 1e308,  infinity, 7,      -3.5,     1e9, -infinity};
  std::vector<std::size_t> order(distances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return distances[i]; });
  RetrievalTask task;
  task.query_classes = {1};
  task.own_column = {-1};
  for (const unsigned relevant : {0x2aaaaU, 0x15555U, 0x0c30fU, 0x00208U, 0x20002U, 0x3ffffU}) {  // by bit
    task.target_classes.clear();
    for (std::size_t i = 0; i < distances.size(); ++i)
      task.target_classes.push_back(static_cast<int>(relevant >> i & 1U));
    std::vector<double> expected;
    for (std::size_t rank = 1; rank <= order.size(); ++rank) {
      if (task.target_classes[order[rank - 1]] == 0) continue;
      expected.push_back(static_cast<double>(expected.size() + 1) / static_cast<double>(rank));
    }
    EXPECT_EQ(ranked_list(std::span(distances), Relevance(task), 0, {}).precision_at_hit, expected) << relevant;
  }
}

TEST(RankedList, OrdersTiesAsRequested) {
  const std::vector<double> row = {2, 2, 9, 2, 2};
  EXPECT_THAT(ranked(row, alternating, Protocol::psb, Ties::index).runs,
              ElementsAre(RankRun{1, 1}, RankRun{2, 0}, RankRun{1, 1}));
  EXPECT_THAT(ranked(row, alternating, Protocol::psb, Ties::optimistic).runs,
              ElementsAre(RankRun{2, 2}, RankRun{2, 0}));
  EXPECT_THAT(ranked(row, alternating, Protocol::psb, Ties::pessimistic).runs,
              ElementsAre(RankRun{2, 0}, RankRun{2, 2}));
  EXPECT_THAT(ranked(row, alternating, Protocol::psb, Ties::expected).runs, ElementsAre(RankRun{4, 2}));
  for (const std::string& name : list_of_words<Ties>()) {
    EXPECT_TRUE(ranked(row, alternating, Protocol::psb, value_of_word<Ties>(name).value()).tied) << name;
  }
}

TEST(RankedList, DoesNotDependOnTheOrderOfTiesOfEqualRelevance) {
  const RankedList list = ranked({1, 2, 9, 2, 1}, alternating, Protocol::psb, Ties::expected);
  EXPECT_THAT(list.runs, ElementsAre(RankRun{2, 2}, RankRun{2, 0}));
  EXPECT_FALSE(list.tied);
}

TEST(RankedList, AcceptsTargetsThatAreNotQueries) {
  RetrievalTask task = leave_one_out(alternating);
  task.target_classes = {5, no_class, 5, 8, 5};
  task.own_column = {-1, -1, -1, -1, -1};
  const RankedList list = list_of(std::vector<double>{0, 1, 2, 3, 4}, task);
  EXPECT_THAT(list.runs, ElementsAre(RankRun{2, 2}, RankRun{1, 0}, RankRun{1, 1}));
}

TEST(RankedList, UsesJudgementsForRelevance) {
  RetrievalTask task = leave_one_out(alternating);
  task.judged = {{}, {}, {1, 3}, {}, {}};
  const RankedList list = list_of(std::vector<double>{0, 1, 2, 3, 4}, task);
  EXPECT_THAT(list.runs, ElementsAre(RankRun{1, 0}, RankRun{2, 2}, RankRun{1, 0}));
}

TEST(RankedList, MayEndBeforeAllModelsAreRanked) {
  const RankedList list = list_of(std::vector<ListedModel>{{2, 2}, {1, 1}, {0, 0}}, leave_one_out(alternating));
  EXPECT_THAT(list.runs, ElementsAre(RankRun{1, 1}, RankRun{1, 0}));
  EXPECT_EQ(list.length, 2U);
  EXPECT_EQ(list.relevant, 2U);
  EXPECT_THAT(list.precision_at_hit, ElementsAre(1, 0));
}

TEST(RankedList, WithoutRetrievedModelsScoresZeroUnderEveryProtocol) {
  const RetrievalTask task = leave_one_out(alternating);
  for (const std::string& protocol : list_of_words<Protocol>()) {
    const ListConventions conventions{.protocol = value_of_word<Protocol>(protocol).value(), .ties = Ties::optimistic};
    for (const RankedList& list :
         {list_of(std::vector<double>{infinity, infinity, 0, infinity, infinity}, task, conventions),
          list_of(std::vector<ListedModel>(), task, conventions)}) {
      EXPECT_EQ(list.length, 0U) << protocol;
      EXPECT_EQ(list.relevant, protocol == "paper" ? 3U : 2U);
      EXPECT_THAT(list.precision_at_hit, testing::Each(0.0));
      EXPECT_FALSE(list.tied);
      for (std::string name : measure_definitions().names()) {
        if (name.ends_with("@k")) name.back() = '3';
        EXPECT_EQ(measure_of(name).value(list), 0) << protocol << " " << name;
      }
      for (const std::string& curve : list_of_words<CurveKind>()) {
        EXPECT_EQ(precision_at_levels(list, value_of_word<CurveKind>(curve).value(), 3).maxCoeff(), 0)
            << protocol << " " << curve;
      }
    }
  }
}

TEST(RankedList, ContainsOnlyTheQueryUnderThePaperProtocolWithoutAnswers) {
  const std::vector<ListedModel> itself{{2, 1}};
  const RetrievalTask task = leave_one_out(alternating);
  EXPECT_EQ(list_of(itself, task).length, 0U);
  EXPECT_EQ(list_of(itself, task, {.protocol = Protocol::paper, .ties = Ties::index}).length, 1U);
}

TEST(RankedList, KeepsAllModelsIfOneDistanceIsFinite) {
  const RankedList list = list_of(std::vector<double>{infinity, 5, 0, infinity, infinity}, leave_one_out(alternating));
  EXPECT_EQ(list.length, 4U);
  EXPECT_EQ(list.precision_at_hit, (std::vector<double>{0.5, 0.5}));
}

TEST(RankedList, CountsHitsUpToARank) {
  const RankedList list = list_of_hits({false, true, true, false, true});
  EXPECT_EQ(hits_among_first(list, 0), 0);
  EXPECT_EQ(hits_among_first(list, 2), 1);
  EXPECT_EQ(hits_among_first(list, 5), 3);
  EXPECT_EQ(hits_among_first(list, 99), 3);
  EXPECT_EQ(gain_of_hits(list, [](std::size_t rank) { return static_cast<double>(rank); }), 2 + 3 + 5);
}

TEST(RankedList, AveragesHitCountsAndGainsOverAllOrdersOfTies) {
  // Ranks 2 to 4 with two hits in any order.
  const RankedList list = list_of_runs({{1, 1}, {3, 2}});
  EXPECT_DOUBLE_EQ(hits_among_first(list, 3), 1 + 2 * 2.0 / 3);
  EXPECT_DOUBLE_EQ(gain_of_hits(list, [](std::size_t rank) { return static_cast<double>(rank); }), 1 + 2 * 3.0);
}

TEST(TiedHits, SingleHitIsEquallyLikelyAtEachTiedRank) {
  const RankedList list = list_of_runs({{2, 0}, {4, 1}});
  ASSERT_EQ(list.precision_at_hit.size(), 1U);
  EXPECT_DOUBLE_EQ(list.precision_at_hit[0], (1.0 / 3 + 1.0 / 4 + 1.0 / 5 + 1.0 / 6) / 4);
}

TEST(TiedHits, PrecisionIncludesTheHitsBeforeTheTie) {
  // Orders of {hit, miss, hit} behind a hit at rank 1 and a miss: second hit at 3, 3, 4; third at 4, 5, 5.
  const RankedList list = list_of_runs({{1, 1}, {1, 0}, {3, 2}});
  EXPECT_DOUBLE_EQ(list.precision_at_hit[1], 2 * (1.0 / 3 + 1.0 / 3 + 1.0 / 4) / 3);
  EXPECT_DOUBLE_EQ(list.precision_at_hit[2], 3 * (1.0 / 4 + 1.0 / 5 + 1.0 / 5) / 3);
}

// The mean of the sum of the precisions at all hits also has a closed form: in n ranks with m hits, rank i is a hit
// with the probability m/n, and then 1 + (i - 1)(m - 1)/(n - 1) hits are among the first i.
TEST(TiedHits, MatchTheClosedFormOfAveragePrecisionForLargeTies) {
  for (const auto& [size, hits] : {std::pair{20000, 19}, {20000, 10000}, {3001, 3000}, {1000, 2}}) {
    const std::vector<double> precisions =
        list_of_runs({{static_cast<std::size_t>(size), static_cast<std::size_t>(hits)}}).precision_at_hit;
    double expected = 0;
    for (int i = 1; i <= size; ++i) {
      expected += (1 + (i - 1.0) * (hits - 1.0) / (size - 1.0)) / i * hits / size;
    }
    const double sum = std::accumulate(precisions.begin(), precisions.end(), 0.0);
    EXPECT_NEAR(sum, expected, 1e-11 * expected) << size << " " << hits;
  }
}

// Columns 0, 1, 3, 4 are judged with grades 1, 3, 2 and irrelevant; the query is column 2.
RetrievalTask graded_task() {
  RetrievalTask task = leave_one_out(alternating);
  task.judged = {{}, {}, {0, 1, 3}, {}, {}};
  task.grades = {{}, {}, {1, 3, 2}, {}, {}};
  task.judged_irrelevant = {{}, {}, {4}, {}, {}};
  return task;
}

TEST(RankedList, HasTheGradesOfItsHits) {
  const RankedList list = list_of(std::vector<double>{0, 1, 9, 3, 2}, graded_task());
  EXPECT_THAT(list.runs, ElementsAre(RankRun{1, 1, 0, 1}, RankRun{1, 1, 0, 3}, RankRun{1, 0}, RankRun{1, 1, 0, 2}));
  EXPECT_THAT(list.grades, ElementsAre(3, 2, 1));
  EXPECT_EQ(list.judged_misses, 1U);
}

TEST(RankedList, OrdersTiedModelsByGradeAsRequested) {
  const auto runs = [&](Ties ties) {
    return list_of(std::vector<double>{5, 5, 9, 5, 7}, graded_task(), {.protocol = Protocol::trec, .ties = ties}).runs;
  };
  const RankRun one{1, 1, 0, 1};
  const RankRun two{1, 1, 0, 2};
  const RankRun three{1, 1, 0, 3};
  EXPECT_THAT(runs(Ties::index), ElementsAre(one, three, two, RankRun{1, 0}));
  EXPECT_THAT(runs(Ties::optimistic), ElementsAre(three, two, one, RankRun{1, 0}));
  EXPECT_THAT(runs(Ties::pessimistic), ElementsAre(one, two, three, RankRun{1, 0}));
  EXPECT_THAT(runs(Ties::expected), ElementsAre(RankRun{3, 3, 0, 2}, RankRun{1, 0}));
}

TEST(RankedList, CountsOnlyJudgedNonRelevantModelsAsMisses) {
  RetrievalTask task = graded_task();
  task.judged = {{}, {}, {0}, {}, {}};
  task.grades = {{}, {}, {1}, {}, {}};
  const RankedList list = list_of(std::vector<double>{4, 1, 9, 2, 3}, task);
  EXPECT_THAT(list.runs, ElementsAre(RankRun{3, 0, 1}, RankRun{1, 1}));
  EXPECT_EQ(list.judged_misses, 1U);
  // A judged model that is not found counts as well.
  const RankedList cut_off = list_of(std::vector<ListedModel>{{0, 4}, {1, 1}, {3, 2}}, task);
  EXPECT_THAT(cut_off.runs, ElementsAre(RankRun{2, 0, 0}, RankRun{1, 1}));
  EXPECT_EQ(cut_off.judged_misses, 1U);
}

}  // namespace

}  // namespace shapegauge
