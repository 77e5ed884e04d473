#include <algorithm>
#include <gmock/gmock.h>

#include "shapegauge/experiments/configuration/fields.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/datasets/layouts.h"
#include "shapegauge/metrics/protocol.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {

namespace {

using testing::Eq;
using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::json;

Json valid() {
  return Json::parse(R"({
    "name": "x",
    "dataset": {"layout": "shrec11", "root": "data"},
    "signatures": [
      {"name": "a", "field": {"type": "offset_sdf", "offset": 0.05}, "histogram": {"range": "per-shape"}},
      {"name": "b", "field": {"type": "cone_sdf", "rays": 9}, "histogram": {"range": {"fixed": [0, 0.6]}}},
      {"name": "c", "concatenate": ["a", "b"]}
    ]})");
}

/// The message for the valid configuration with the value at a JSON pointer replaced.
std::string message_with(const std::string& pointer, const Json& value) {
  Json document = valid();
  document[Json::json_pointer(pointer)] = value;
  return input_error_of([&] { check_against_schema(document, "x.json"); });
}

std::string message_without(const std::string& parent, const std::string& key) {
  Json document = valid();
  document[Json::json_pointer(parent)].erase(key);
  return input_error_of([&] { check_against_schema(document, "x.json"); });
}

TEST(SchemaCheck, AcceptsAValidConfiguration) { EXPECT_NO_THROW(check_against_schema(valid(), "x.json")); }

TEST(SchemaCheck, UnknownKeysWithTheNearestKnownOne) {
  EXPECT_THAT(message_with("/signature", 1), Eq("x.json: unknown key \"signature\"; did you mean \"signatures\"?"));
  EXPECT_THAT(message_with("/signatures/0/field/ofset", 1),
              Eq("x.json: signatures.0.field: unknown key \"ofset\"; did you mean \"offset\"?"));
  EXPECT_THAT(message_with("/signatures/0/histogram/bin", 1),
              Eq("x.json: signatures.0.histogram: unknown key \"bin\"; did you mean \"bins\"?"));
  EXPECT_THAT(message_with("/dataset/roots", "x"), HasSubstr("dataset: unknown key \"roots\"; did you mean \"root\"?"));
}

TEST(SchemaCheck, AKeyOfAnotherFieldTypeIsUnknown) {
  const std::string message = message_with("/signatures/0/field/rays", 25);
  EXPECT_THAT(message, StartsWith("x.json: signatures.0.field: unknown key \"rays\"; known here: "));
  EXPECT_THAT(message, HasSubstr("\"offset\""));
}

TEST(SchemaCheck, AMisspeltKeyCountsBeforeTheOneThatIsMissingForIt) {
  Json document = valid();
  document["signatures"][0]["fields"] = document["signatures"][0]["field"];
  document["signatures"][0].erase("field");
  EXPECT_THAT(input_error_of([&] { check_against_schema(document, "x.json"); }),
              Eq("x.json: signatures.0: unknown key \"fields\"; did you mean \"field\"?"));
}

TEST(SchemaCheck, UnknownWordsWithTheNearestKnownOne) {
  EXPECT_THAT(message_with("/signatures/1/field/type", "conesdf"),
              Eq("x.json: signatures.1.field.type: unknown word \"conesdf\"; did you mean \"cone_sdf\"?"));
  EXPECT_THAT(message_with("/protocol", "pbs"), Eq("x.json: protocol: unknown word \"pbs\"; did you mean \"psb\"?"));
  EXPECT_THAT(message_with("/protocol", Json::array({"psb", "papers"})),
              Eq("x.json: protocol.1: unknown word \"papers\"; did you mean \"paper\"?"));
  EXPECT_THAT(message_with("/signatures/0/histogram/range", "pershape"),
              Eq("x.json: signatures.0.histogram.range: unknown word \"pershape\"; did you mean \"per-shape\"?"));
  EXPECT_THAT(message_with("/dataset/layout", "modelnet"), HasSubstr("known here: \"shrec11\", \"folders\", \"csv\""));
  EXPECT_THAT(message_with("/on_error", 3), HasSubstr("on_error: must be one of \"stop\", \"skip\", not 3"));
}

TEST(SchemaCheck, WrongTypes) {
  EXPECT_THAT(message_with("/signatures/0/histogram/bins", "80"),
              Eq("x.json: signatures.0.histogram.bins: must be of type integer, not string (\"80\")"));
  EXPECT_THAT(message_with("/signatures/0/histogram/bins", 8.5),
              HasSubstr("must be of type integer, not number (8.5)"));
  EXPECT_THAT(message_with("/signatures/0/field/offset", true), HasSubstr("must be of type number, not boolean"));
  EXPECT_THAT(message_with("/signatures", Json::object()), HasSubstr("signatures: must be of type array, not object"));
  EXPECT_THAT(message_with("/dataset", "data"), HasSubstr("dataset: must be of type object, not string"));
  EXPECT_THAT(input_error_of([] { check_against_schema(Json::array(), "x.json"); }),
              HasSubstr("x.json: must be of type object, not array"));
}

TEST(SchemaCheck, NumbersOutOfRange) {
  EXPECT_THAT(message_with("/signatures/0/field/offset", 0),
              Eq("x.json: signatures.0.field.offset: must be a number greater than 0, not 0"));
  EXPECT_THAT(message_with("/signatures/0/field/offset", 5), HasSubstr("less than or equal to 1, not 5"));
  EXPECT_THAT(message_with("/signatures/0/histogram/bins", 0), HasSubstr("greater than or equal to 1, not 0"));
}

TEST(SchemaCheck, MissingKeys) {
  EXPECT_THAT(message_without("", "name"), Eq("x.json: the key \"name\" is missing"));
  EXPECT_THAT(message_without("/signatures/0/field", "offset"),
              Eq("x.json: signatures.0.field: the key \"offset\" is missing"));
  EXPECT_THAT(message_without("/signatures/0", "histogram"),
              HasSubstr("signatures.0: the key \"histogram\" is missing"));
  EXPECT_THAT(message_without("/dataset", "root"), HasSubstr("dataset: the key \"root\" is missing"));
}

TEST(SchemaCheck, EmptyListsAndLineBreaksInNames) {
  EXPECT_THAT(message_with("/signatures", Json::array()), StartsWith("x.json: signatures: "));
  EXPECT_THAT(message_with("/protocol", Json::array({"psb", "psb"})), StartsWith("x.json: protocol: "));
  EXPECT_THAT(message_with("/signatures/0/histogram/range", Json::parse(R"({"fixed": [0]})")),
              StartsWith("x.json: signatures.0.histogram.range.fixed: "));
  EXPECT_THAT(message_with("/signatures/0/name", "a\nb"), StartsWith("x.json: signatures.0.name: "));
}

TEST(SchemaCheck, EndlessTexts) {
  const std::string endless(1'000'000, 'x');
  EXPECT_THAT(message_with("/signatures/0/name", endless), Eq("no error"));
  EXPECT_THAT(message_with("/signatures/0/name", endless + "\n"), StartsWith("x.json: signatures.0.name: "));
  EXPECT_LT(message_with("/protocol", endless).size(), 1000U);
  EXPECT_LT(message_with("/signatures/0/histogram/bins", endless).size(), 1000U);
  EXPECT_LT(message_with("/signatures/0/" + endless, 1).size(), 1000U);
}

std::vector<std::string> words_at(const std::string& pointer) {
  return Json::parse(experiment_schema()).at(Json::json_pointer(pointer)).get<std::vector<std::string>>();
}

template <typename Types>
std::vector<std::string> names_of(const Types& types) {
  std::vector<std::string> names;
  for (const auto& type : types) names.emplace_back(type.name);
  return names;
}

TEST(ExperimentSchema, NamesWhatTheRegistriesName) {
  EXPECT_EQ(words_at("/definitions/field/properties/type/enum"), names_of(field_types()));
  EXPECT_EQ(words_at("/definitions/dataset/properties/layout/enum"), names_of(dataset_layouts()));
  EXPECT_EQ(words_at("/definitions/protocol/enum"), protocol_names());
  EXPECT_EQ(words_at("/definitions/retrieval_experiment/properties/distance/enum"), distance_names());
  EXPECT_EQ(words_at("/definitions/retrieval_experiment/properties/evaluation/properties/ties/enum"), ties_names());
}

}  // namespace

}  // namespace shapegauge
