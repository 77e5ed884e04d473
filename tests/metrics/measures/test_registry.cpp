#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>

#include "shapegauge/metrics/measures/registry.h"

namespace shapegauge {
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
