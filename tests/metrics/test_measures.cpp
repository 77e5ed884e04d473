#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>

#include "shapegauge/metrics/measures.h"

namespace shapegauge {

namespace {

double tenth_of(std::size_t rank) { return 0.1 / static_cast<double>(rank); }

TEST(ShareOfIdealGain, OneForAPerfectListExactly) {
  EXPECT_EQ(share_of_ideal_gain(list_of_hits({true, true, true, false}), tenth_of), 1);
}

TEST(ShareOfIdealGain, RelevantModelsThatAreNotInTheListCountInTheIdeal) {
  // (1/2 + 1/3) / (1 + 1/2 + 1/3)
  EXPECT_DOUBLE_EQ(share_of_ideal_gain(list_of_hits({false, true, true}, false, 1), tenth_of), 5.0 / 11);
}

}  // namespace

namespace {

TEST(NearestNeighbour, LooksAtTheFirstRank) {
  EXPECT_EQ(nearest_neighbour(list_of_hits({true, false})), 1);
  EXPECT_EQ(nearest_neighbour(list_of_hits({false, true})), 0);
}

TEST(NearestNeighbour, PassesOverTheQuery) {
  EXPECT_EQ(nearest_neighbour(list_of_hits({true, false, true}, true)), 0);
  EXPECT_EQ(nearest_neighbour(list_of_hits({true, true, false}, true)), 1);
}

}  // namespace

namespace {

TEST(FirstTier, CountsHitsAmongTheFirstR) {
  EXPECT_DOUBLE_EQ(first_tier(list_of_hits({true, false, false, true, false, false, true})), 1.0 / 3);
}

TEST(FirstTier, CountsRelevantModelsThatAreNotInTheList) {
  EXPECT_DOUBLE_EQ(first_tier(list_of_hits({true, false}, false, 3)), 1.0 / 4);
}

}  // namespace

namespace {

TEST(SecondTier, CountsHitsAmongTheFirstTwiceR) {
  EXPECT_DOUBLE_EQ(second_tier(list_of_hits({true, false, false, true, false, false, true})), 2.0 / 3);
}

TEST(SecondTier, EndsWithTheList) { EXPECT_DOUBLE_EQ(second_tier(list_of_hits({false, true, true, true})), 1); }

}  // namespace

namespace {

TEST(EMeasure, IsTheHarmonicMeanOfPrecisionAndRecallAmongThirtyTwo) {
  std::vector<bool> hits(100, false);
  for (const std::size_t rank : {1, 5, 20, 32, 33, 50, 60, 70}) hits[rank - 1] = true;
  const double precision = 4.0 / 32;
  const double recall = 4.0 / 8;
  EXPECT_DOUBLE_EQ(e_measure(list_of_hits(hits)), 2 / (1 / precision + 1 / recall));
}

TEST(EMeasure, LooksAtAShorterListAsAWhole) {
  // Four results, two of them relevant, all found: precision 1/2, recall 1.
  EXPECT_DOUBLE_EQ(e_measure(list_of_hits({false, true, false, true})), 2.0 / 3);
}

TEST(EMeasure, IsZeroWithoutHitsInFront) { EXPECT_EQ(e_measure(list_of_runs({{39, 0}, {1, 1}})), 0); }

}  // namespace

namespace {

TEST(DiscountedCumulativeGain, OfAWorkedExample) {
  // Hits at ranks 2, 4, 8 gain 1, 1/2, 1/3; in front they would gain 1, 1, 1/log2(3).
  const RankedList list = list_of_hits({false, true, false, true, false, false, false, true});
  const double log2_of_3 = 1.584962500721156;
  EXPECT_DOUBLE_EQ(discounted_cumulative_gain(list), (1 + 0.5 + 1.0 / 3) / (2 + 1 / log2_of_3));
}

TEST(DiscountedCumulativeGain, IsExactlyOneForAPerfectList) {
  for (std::size_t relevant = 1; relevant <= 40; ++relevant) {
    const RankedList list = list_of_runs({{relevant, relevant}, {60 - relevant, 0}});
    EXPECT_EQ(discounted_cumulative_gain(list), 1) << relevant;
  }
}

TEST(DiscountedCumulativeGain, CountsTheFirstTwoRanksTheSame) {
  EXPECT_EQ(discounted_cumulative_gain(list_of_hits({true, false, false})), 1);
  EXPECT_EQ(discounted_cumulative_gain(list_of_hits({false, true, false})), 1);
  EXPECT_LT(discounted_cumulative_gain(list_of_hits({false, false, true})), 1);
}

}  // namespace

namespace {

// The textbook example of Manning, Raghavan and Schuetze's kind: hits at ranks 1, 3, 6.
TEST(AveragePrecision, IsTheMeanPrecisionAtTheHits) {
  EXPECT_DOUBLE_EQ(average_precision(list_of_hits({true, false, true, false, false, true})),
                   (1.0 / 1 + 2.0 / 3 + 3.0 / 6) / 3);
}

TEST(AveragePrecision, IsOneForAPerfectList) {
  EXPECT_EQ(average_precision(list_of_hits({true, true, true, false, false})), 1);
}

}  // namespace

namespace {

TEST(PrecisionAt, DividesByKEvenWhereTheListIsShorter) {
  const RankedList list = list_of_hits({true, false, true});
  EXPECT_EQ(precision_at(list, 1), 1);
  EXPECT_EQ(precision_at(list, 2), 0.5);
  EXPECT_EQ(precision_at(list, 10), 0.2);
}

}  // namespace

namespace {

TEST(RecallAt, DividesByAllRelevantModels) {
  const RankedList list = list_of_hits({true, false, true}, false, 2);
  EXPECT_EQ(recall_at(list, 2), 0.25);
  EXPECT_EQ(recall_at(list, 10), 0.5);
}

}  // namespace

namespace {

TEST(F1At, IsTheHarmonicMeanOfPrecisionAndRecall) {
  const RankedList list = list_of_hits({true, false, true, false, false, true});
  EXPECT_DOUBLE_EQ(f1_at(list, 4), 2 / (1 / 0.5 + 1 / (2.0 / 3)));
  EXPECT_EQ(f1_at(list_of_hits({false, true}), 1), 0);
}

}  // namespace

namespace {

TEST(RPrecision, IsThePrecisionAtRankR) {
  EXPECT_DOUBLE_EQ(r_precision_definition.value(list_of_hits({true, false, true, true})), 2.0 / 3);
}

}  // namespace

namespace {

TEST(ReciprocalRank, LooksAtTheFirstHit) {
  EXPECT_EQ(reciprocal_rank(list_of_hits({false, false, false, true, true})), 0.25);
  EXPECT_EQ(reciprocal_rank(list_of_hits({false}, false, 1)), 0);
}

TEST(ReciprocalRank, IsTheMeanOverTheOrdersOfTheTied) {
  // One hit at any of the ranks 2, 3, 4.
  EXPECT_DOUBLE_EQ(reciprocal_rank(list_of_runs({{1, 0}, {3, 1}})), (1.0 / 2 + 1.0 / 3 + 1.0 / 4) / 3);
}

}  // namespace

namespace {

TEST(NormalisedDiscountedGain, OfAWorkedExample) {
  // Hits at ranks 1, 3, 7 gain 1, 1/2, 1/3; in front they would gain 1, 1/log2(3), 1/2.
  const RankedList list = list_of_hits({true, false, true, false, false, false, true});
  const double log2_of_3 = 1.584962500721156;
  EXPECT_DOUBLE_EQ(normalised_discounted_gain(list), (1 + 0.5 + 1.0 / 3) / (1.5 + 1 / log2_of_3));
}

TEST(NormalisedDiscountedGain, IsExactlyOneForAPerfectList) {
  EXPECT_EQ(normalised_discounted_gain(list_of_runs({{19, 19}, {580, 0}})), 1);
}

}  // namespace

namespace {

TEST(BullsEye, CountsTheQueryUnderEveryProtocol) {
  // A class of three: six ranks with the query.
  EXPECT_DOUBLE_EQ(bulls_eye(list_of_hits({false, true, false, false, false, true})), 2.0 / 3);
  EXPECT_DOUBLE_EQ(bulls_eye(list_of_hits({true, false, true, false, false, false, true}, true)), 2.0 / 3);
}

}  // namespace

namespace {

TEST(AreaUnderCurve, IsThatOfTrapezia) {
  // Precision 1, 2/3, 1/2 at recall 1/3, 2/3, 1.
  const RankedList list = list_of_hits({true, false, true, false, false, true});
  EXPECT_DOUBLE_EQ(area_under_curve(list), (1 + (1 + 2.0 / 3) / 2 + (2.0 / 3 + 0.5) / 2) / 3);
}

TEST(AreaUnderCurve, IsOneForAPerfectList) { EXPECT_EQ(area_under_curve(list_of_hits({true, true, false})), 1); }

}  // namespace

namespace {

using testing::HasSubstr;

std::string error_of(const std::string& name) {
  try {
    measure_of(name);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

std::vector<Measure> one_of_each() {
  std::vector<Measure> measures;
  for (const MeasureDefinition& definition : measure_definitions()) {
    std::string name(definition.name);
    if (definition.value_at != nullptr) name.back() = '3';
    measures.push_back(measure_of(name));
  }
  return measures;
}

TEST(MeasureRegistry, NamesAreDifferentAndEverythingIsExplained) {
  std::set<std::string_view> names;
  for (const MeasureDefinition& definition : measure_definitions()) {
    names.insert(definition.name);
    for (const auto text : {definition.name, definition.title, definition.definition, definition.source}) {
      EXPECT_FALSE(text.empty()) << definition.name;
    }
    EXPECT_FALSE(definition.caveat.empty()) << definition.name;
    EXPECT_NE(definition.value == nullptr, definition.value_at == nullptr) << definition.name;
    EXPECT_EQ(definition.value_at != nullptr, definition.name.ends_with("@k")) << definition.name;
  }
  EXPECT_EQ(names.size(), measure_definitions().size());
}

TEST(MeasureRegistry, FindsMeasuresByName) {
  EXPECT_EQ(measure_of("FT").definition->title, "first tier");
  EXPECT_EQ(measure_of("P@10").k, 10U);
  EXPECT_EQ(measure_of("P@10").name, "P@10");
  EXPECT_EQ(measure_of("AP").name, "mAP");
}

TEST(MeasureRegistry, NoMeasureIsNamedTwice) {
  EXPECT_EQ(measures_of(std::vector<std::string>{"P@1", "P@2"}).size(), 2U);
  EXPECT_THROW(measures_of(std::vector<std::string>{"mAP", "FT", "AP"}), std::invalid_argument);
}

TEST(MeasureRegistry, OtherNamesAreErrors) {
  EXPECT_THAT(error_of("PP"), HasSubstr("no measure \"PP\"; known are: NN FT ST"));
  EXPECT_THAT(error_of("FT@3"), HasSubstr("no measure \"FT@3\""));
  for (const char* name : {"P@0", "P@", "P@x", "P@-1", "P@1.5", "P@k", "P@99999999999"}) {
    EXPECT_THAT(error_of(name), HasSubstr("needs a number of ranks from 1 to 1000000000 after the @, as in P@10"));
  }
  EXPECT_THAT(error_of("P"), HasSubstr("no measure"));
  EXPECT_THAT(error_of(""), HasSubstr("no measure"));
}

TEST(MeasureRegistry, ProtocolsThatShareATableShareTheirMeasures) {
  std::vector<std::string> names;
  for (const Measure& measure :
       default_measures(std::vector<Protocol>{Protocol::psb, Protocol::paper, Protocol::trec})) {
    names.push_back(measure.name);
  }
  EXPECT_THAT(names,
              testing::ElementsAre("NN", "FT", "ST", "E", "DCG", "mAP", "P@10", "R@10", "MRR", "nDCG", "R-prec"));
}

// Every list of up to ten ranks with a hit, with and without a relevant model that is not in it: a measure that is
// added must keep what the registry promises.
TEST(MeasureRegistry, ValuesAreFractionsForEveryShortList) {
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

}  // namespace

}  // namespace shapegauge
