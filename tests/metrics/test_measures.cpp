// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/measures.h"
#include "tests/metrics/list_of_hits.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;

double value(const std::string& measure, const RankedList& list) { return measure_of(measure).value(list); }

TEST(NearestNeighbour, ScoresTheModelAtTheFirstRank) {
  EXPECT_EQ(value("NN", list_of_hits({true, false})), 1);
  EXPECT_EQ(value("NN", list_of_hits({false, true})), 0);
}

TEST(NearestNeighbour, IgnoresTheQueryItself) {
  EXPECT_EQ(value("NN", list_of_hits({true, false, true}, true)), 0);
  EXPECT_EQ(value("NN", list_of_hits({true, true, false}, true)), 1);
}

TEST(FirstTier, IsTheRecallAtTheNumberOfRelevantModels) {
  EXPECT_DOUBLE_EQ(value("FT", list_of_hits({true, false, false, true, false, false, true})), 1.0 / 3);
}

TEST(FirstTier, CountsRelevantModelsMissingFromTheListAsMisses) {
  EXPECT_DOUBLE_EQ(value("FT", list_of_hits({true, false}, false, 3)), 1.0 / 4);
}

TEST(SecondTier, IsTheRecallAtTwiceTheNumberOfRelevantModels) {
  EXPECT_DOUBLE_EQ(value("ST", list_of_hits({true, false, false, true, false, false, true})), 2.0 / 3);
}

TEST(SecondTier, CountsAllHitsIfTheListIsShorterThanTheTier) {
  EXPECT_DOUBLE_EQ(value("ST", list_of_hits({false, true, true, true})), 1);
}

TEST(EMeasure, IsTheHarmonicMeanOfPrecisionAndRecallAtRank32) {
  std::vector<bool> hits(100, false);
  for (const std::size_t rank : {1, 5, 20, 32, 33, 50, 60, 70}) hits[rank - 1] = true;
  const double precision = 4.0 / 32;
  const double recall = 4.0 / 8;
  EXPECT_DOUBLE_EQ(value("E", list_of_hits(hits)), 2 / (1 / precision + 1 / recall));
}

TEST(EMeasure, UsesAllRanksOfAListShorterThan32) {
  // Four results, two of them relevant, all found: precision 1/2, recall 1.
  EXPECT_DOUBLE_EQ(value("E", list_of_hits({false, true, false, true})), 2.0 / 3);
}

TEST(EMeasure, IsZeroWithoutHits) { EXPECT_EQ(value("E", list_of_runs({{39, 0}, {1, 1}})), 0); }

TEST(DiscountedCumulativeGain, MatchesAWorkedExample) {
  // Hits at ranks 2, 4, 8 gain 1, 1/2, 1/3; in front they would gain 1, 1, 1/log2(3).
  const RankedList list = list_of_hits({false, true, false, true, false, false, false, true});
  const double log2_of_3 = 1.584962500721156;
  EXPECT_DOUBLE_EQ(value("DCG", list), (1 + 0.5 + 1.0 / 3) / (2 + 1 / log2_of_3));
}

TEST(DiscountedCumulativeGain, IsExactlyOneForAPerfectList) {
  for (std::size_t relevant = 1; relevant <= 40; ++relevant) {
    const RankedList list = list_of_runs({{relevant, relevant}, {60 - relevant, 0}});
    EXPECT_EQ(value("DCG", list), 1) << relevant;
  }
}

TEST(DiscountedCumulativeGain, WeighsTheFirstTwoRanksEqually) {
  EXPECT_EQ(value("DCG", list_of_hits({true, false, false})), 1);
  EXPECT_EQ(value("DCG", list_of_hits({false, true, false})), 1);
  EXPECT_LT(value("DCG", list_of_hits({false, false, true})), 1);
}

// Example in the style of Manning, Raghavan and Schuetze: hits at ranks 1, 3, 6.
TEST(AveragePrecision, IsOneForAPerfectList) {
  EXPECT_EQ(value("mAP", list_of_hits({true, true, true, false, false})), 1);
}

TEST(AveragePrecision, IsTheMeanPrecisionAtTheHits) {
  EXPECT_DOUBLE_EQ(value("mAP", list_of_hits({true, false, true, false, false, true})),
                   (1.0 / 1 + 2.0 / 3 + 3.0 / 6) / 3);
}

TEST(PrecisionAtK, DividesByKForShorterLists) {
  const RankedList list = list_of_hits({true, false, true});
  EXPECT_EQ(value("P@1", list), 1);
  EXPECT_EQ(value("P@2", list), 0.5);
  EXPECT_EQ(value("P@10", list), 0.2);
}

TEST(RecallAtK, DividesByAllRelevantModels) {
  const RankedList list = list_of_hits({true, false, true}, false, 2);
  EXPECT_EQ(value("R@2", list), 0.25);
  EXPECT_EQ(value("R@10", list), 0.5);
}

TEST(F1AtK, IsTheHarmonicMeanOfPrecisionAndRecall) {
  const RankedList list = list_of_hits({true, false, true, false, false, true});
  EXPECT_DOUBLE_EQ(value("F1@4", list), 2 / (1 / 0.5 + 1 / (2.0 / 3)));
  EXPECT_EQ(value("F1@1", list_of_hits({false, true})), 0);
}

TEST(RPrecision, IsThePrecisionAtTheNumberOfRelevantModels) {
  EXPECT_DOUBLE_EQ(value("R-prec", list_of_hits({true, false, true, true})), 2.0 / 3);
}

TEST(ReciprocalRank, IsTheReciprocalOfTheRankOfTheFirstHit) {
  EXPECT_EQ(value("MRR", list_of_hits({false, false, false, true, true})), 0.25);
  EXPECT_EQ(value("MRR", list_of_hits({false}, false, 1)), 0);
}

TEST(ReciprocalRank, IsTheMeanOverAllOrdersOfTies) {
  // One hit at any of the ranks 2, 3, 4.
  EXPECT_DOUBLE_EQ(value("MRR", list_of_runs({{1, 0}, {3, 1}})), (1.0 / 2 + 1.0 / 3 + 1.0 / 4) / 3);
}

TEST(NormalisedDiscountedGain, MatchesAWorkedExample) {
  // Hits at ranks 1, 3, 7 gain 1, 1/2, 1/3; in front they would gain 1, 1/log2(3), 1/2.
  const RankedList list = list_of_hits({true, false, true, false, false, false, true});
  const double log2_of_3 = 1.584962500721156;
  EXPECT_DOUBLE_EQ(value("nDCG", list), (1 + 0.5 + 1.0 / 3) / (1.5 + 1 / log2_of_3));
}

TEST(NormalisedDiscountedGain, IdealIncludesRelevantModelsMissingFromTheList) {
  const double log2_of_3 = 1.584962500721156;
  EXPECT_DOUBLE_EQ(value("nDCG", list_of_hits({false, true, true}, false, 1)),
                   (1 / log2_of_3 + 0.5) / (1.5 + 1 / log2_of_3));
}

TEST(NormalisedDiscountedGain, IsExactlyOneForAPerfectList) {
  EXPECT_EQ(value("nDCG", list_of_runs({{19, 19}, {580, 0}})), 1);
}

TEST(BullsEye, CountsTheQueryAsRelevantUnderEveryProtocol) {
  // A class of three: six ranks with the query.
  EXPECT_DOUBLE_EQ(value("BEP", list_of_hits({false, true, false, false, false, true})), 2.0 / 3);
  EXPECT_DOUBLE_EQ(value("BEP", list_of_hits({true, false, true, false, false, false, true}, true)), 2.0 / 3);
}

TEST(AreaUnderCurve, IsTheAreaByTheTrapezoidalRule) {
  // Precision 1, 2/3, 1/2 at recall 1/3, 2/3, 1.
  const RankedList list = list_of_hits({true, false, true, false, false, true});
  EXPECT_DOUBLE_EQ(value("AUC-PR", list), (1 + (1 + 2.0 / 3) / 2 + (2.0 / 3 + 0.5) / 2) / 3);
}

TEST(AreaUnderCurve, IsOneForAPerfectList) { EXPECT_EQ(value("AUC-PR", list_of_hits({true, true, false})), 1); }

std::string measure_error_of(const std::string& name) {
  try {
    measure_of(name);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<Measure> one_of_each() {
  std::vector<Measure> measures;
  for (const MeasureDefinition& definition : measure_definitions().entries()) {
    std::string name(definition.name);
    if (definition.value_at != nullptr) name.back() = '3';
    measures.push_back(measure_of(name));
  }
  return measures;
}

TEST(MeasureRegistry, FindsMeasuresByName) {
  EXPECT_EQ(measure_of("FT").definition->title, "first tier");
  EXPECT_EQ(measure_of("P@10").k, 10U);
  EXPECT_EQ(measure_of("P@10").name, "P@10");
  EXPECT_EQ(measure_of("AP").name, "mAP");
}

TEST(MeasureRegistry, RejectsAListThatNamesAMeasureTwice) {
  EXPECT_EQ(measures_of(std::vector<std::string>{"P@1", "P@2"}).size(), 2U);
  EXPECT_THROW(measures_of(std::vector<std::string>{"mAP", "FT", "AP"}), ArgumentError);
}

TEST(MeasureRegistry, RejectsUnknownMeasureNames) {
  EXPECT_THAT(measure_error_of("PP"), HasSubstr("\"PP\"; did you mean"));
  for (const char* name : {"FT@N", "FT@3", "P", ""})
    EXPECT_THAT(measure_error_of(name), HasSubstr("no measure")) << name;
  for (const char* name : {"P@0", "P@", "P@x", "P@-1", "P@1.5", "P@k", "P@M", "P@99999999999"}) {
    EXPECT_THAT(measure_error_of(name), HasSubstr("1000000000")) << name;
  }
}

// Registers a measure as a user of the library would.
TEST(MeasureRegistry, AcceptsAUserDefinedMeasure) {
  measure_definitions().add({.name = "Miss@k",
                             .title = "misses at k",
                             .definition = "The fraction of misses among the first k ranks.",
                             .source = "this test",
                             .caveat = "none",
                             .value_at = [](const RankedList& list, std::size_t k) {
                               return 1 - hits_among_first(list, k) / static_cast<double>(k);
                             }});
  EXPECT_EQ(value("Miss@4", list_of_hits({true, false, false, true, true})), 0.5);
  EXPECT_EQ(measure_definitions().names().back(), "Miss@k");
  EXPECT_THAT(measure_error_of("nowhere"), HasSubstr("\"Miss@k\""));
}

TEST(MeasureRegistry, RejectsInvalidNamesAndFunctions) {
  const auto half = [](const RankedList&) { return 0.5; };
  const auto half_at = [](const RankedList&, std::size_t) { return 0.5; };
  for (const char* name : {"", "@k", "@N", "a b", "a,b", "a@3", "FT", "AP"}) {
    EXPECT_THROW(measure_definitions().add({.name = name, .value = half}), ArgumentError) << name;
  }
  EXPECT_THROW(measure_definitions().add({.name = "P@k", .value_at = half_at}), ArgumentError);
  EXPECT_THROW(measure_definitions().add({.name = "X", .value_at = half_at}), ArgumentError);
  EXPECT_THROW(measure_definitions().add({.name = "X@k", .value = half}), ArgumentError);
  EXPECT_THROW(measure_definitions().add({.name = "X@N", .value_at = half_at}), ArgumentError);
  EXPECT_THROW(measure_definitions().add({.name = "X", .value = half, .value_at = half_at}), ArgumentError);
  EXPECT_THROW(measure_definitions().add({.name = "X"}), ArgumentError);
  EXPECT_THAT(measure_error_of("X"), HasSubstr("no measure"));
}

TEST(MeasureRegistry, CombinesTheDefaultMeasuresOfSeveralProtocols) {
  std::vector<std::string> names;
  for (const Measure& measure :
       default_measures(std::vector<Protocol>{Protocol::psb, Protocol::paper, Protocol::trec})) {
    names.push_back(measure.name);
  }
  EXPECT_THAT(names,
              testing::ElementsAre("NN", "FT", "ST", "E", "DCG", "mAP", "P@10", "R@10", "MRR", "nDCG", "R-prec"));
}

// Every list of up to ten ranks with a hit, with and without a relevant model outside the list: a measure that is
// added must satisfy the contract of the registry.
TEST(MeasureRegistry, GivesScoresBetweenZeroAndOneForEveryShortList) {
  const std::vector<Measure> measures = one_of_each();
  for (std::size_t length = 1; length <= 10; ++length) {
    for (unsigned pattern = 1; pattern < (1U << length); ++pattern) {
      std::vector<bool> hits;
      for (std::size_t i = 0; i < length; ++i) hits.push_back(((pattern >> i) & 1U) != 0);
      for (const std::size_t not_in_list : {0U, 1U}) {
        const RankedList list = list_of_hits(hits, false, not_in_list);
        for (const Measure& measure : measures) {
          const double value = measure.value(list);
          ASSERT_TRUE(value >= 0 && value <= 1) << measure.name << " of pattern " << pattern << " is " << value;
        }
      }
    }
  }
}

TEST(NormalisedDiscountedGain, UsesGradesAsGains) {
  // Grades 1, 0, 3 at ranks 1, 2, 3, and one of 2 that is not in the list.
  RankedList list = list_of_runs({{.size = 1, .hits = 1, .misses = 0, .grade = 1},
                                  {.size = 1, .hits = 0},
                                  {.size = 1, .hits = 1, .misses = 0, .grade = 3}},
                                 false, 1);
  list.grades = {3, 2, 1};
  EXPECT_DOUBLE_EQ(value("nDCG", list), (1 + 3.0 / 2) / (3 + 2 / std::log2(3) + 1.0 / 2));
  EXPECT_DOUBLE_EQ(value("mAP", list), (1 + 2.0 / 3) / 3);  // ignores grades
}

TEST(BinaryPreference, FallsWithJudgedNonRelevantModelsBeforeEachHit) {
  // Misses at ranks 2, 4 and 5, of which that at rank 4 is not judged: 0, 1, 2 before the hits at 1, 3, 6.
  const RankedList list = list_of_runs({{1, 1}, {1, 0}, {1, 1}, {.size = 2, .hits = 0, .misses = 1}, {1, 1}}, false, 1);
  EXPECT_EQ(list.judged_misses, 2U);
  EXPECT_DOUBLE_EQ(value("bpref", list), ((1 - 0.0 / 2) + (1 - 1.0 / 2) + (1 - 2.0 / 2) + 0) / 4);
}

TEST(BinaryPreference, CountsNoMoreMissesThanRelevantModels) {
  EXPECT_DOUBLE_EQ(value("bpref", list_of_runs({{7, 0}, {2, 2}, {5, 0}})), 0);
  EXPECT_DOUBLE_EQ(value("bpref", list_of_runs({{1, 0}, {2, 2}, {5, 0}})), 0.5);
  EXPECT_EQ(value("bpref", list_of_hits({true, true})), 1);
  for (std::size_t hits = 2; hits < 20; ++hits) {  // in any order of ties, all misses before a hit count as `hits`
    EXPECT_EQ(value("bpref", list_of_runs({{20, 0}, {2 * hits + 1, hits}})), 0) << hits;
  }
}

TEST(BinaryPreference, IsTheMeanOverAllOrdersOfTies) {
  // Behind a miss, two hits and two misses in any order: the six orders one by one.
  double sum = 0;
  std::vector<bool> order = {false, false, true, true};
  do {
    std::vector<bool> hits = {false};
    hits.insert(hits.end(), order.begin(), order.end());
    sum += value("bpref", list_of_hits(hits));
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_NEAR(value("bpref", list_of_runs({{1, 0}, {4, 2}})), sum / 6, 1e-15);
}

}  // namespace

}  // namespace shapegauge
