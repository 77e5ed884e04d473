// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::Eq;
using testing::HasSubstr;
using testing::Not;
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

void check(const Json& document) { check_against_schema(document, "retrieval_experiment", "x.json"); }

/// Error message of the valid configuration after replacing the value at a JSON pointer.
std::string schema_error_with(const std::string& pointer, const Json& value) {
  Json document = valid();
  document[Json::json_pointer(pointer)] = value;
  return test::input_error_of([&] { check(document); });
}

std::string message_without(const std::string& parent, const std::string& key) {
  Json document = valid();
  document[Json::json_pointer(parent)].erase(key);
  return test::input_error_of([&] { check(document); });
}

TEST(SchemaCheck, AcceptsAValidConfiguration) { EXPECT_NO_THROW(check(valid())); }

TEST(SchemaCheck, UnknownKeyErrorNamesTheKindOfExperiment) {
  EXPECT_THAT(schema_error_with("/shapes", Json::array()),
              StartsWith("x.json: unknown key \"shapes\" in a retrieval experiment; known here: \"dataset\", "));
  Json document = valid();
  document["segmentation"] = Json::array();
  document["signatures"][0]["field"]["ray"] = 9;
  EXPECT_THAT(test::input_error_of([&] { check(document); }), StartsWith("x.json: unknown key \"segmentation\" in a "));
}

TEST(SchemaCheck, ReportsAMisspeltKeyBeforeAMissingKey) {
  Json document = valid();
  document["signatures"][0]["fields"] = document["signatures"][0]["field"];
  document["signatures"][0].erase("field");
  EXPECT_THAT(test::input_error_of([&] { check(document); }),
              Eq("x.json: signatures.0: unknown key \"fields\"; did you mean \"field\"?"));
}

TEST(SchemaCheck, ReportsAnUnknownKeyBeforeADeeperInvalidValue) {
  Json document = valid();
  document.erase("name");
  document["signatures"][0]["histogram"]["bins"] = "80";
  const auto error = [&] { return test::input_error_of([&] { check(document); }); };
  EXPECT_THAT(error(), StartsWith("x.json: signatures.0.histogram.bins: "));
  document["nmae"] = "x";
  EXPECT_THAT(error(), StartsWith("x.json: unknown key \"nmae\""));
  document["signatures"][1]["field"]["ray"] = 9;
  EXPECT_THAT(error(), StartsWith("x.json: signatures.1.field: unknown key \"ray\"")) << "the deepest of these";
}

TEST(SchemaCheck, ErrorsNameLocationAndProblem) {
  struct Refusal {
    const char* pointer;
    Json value;
    const char* message;
  };
  const std::vector<Refusal> refusals = {
      {"/signature", 1, "x.json: unknown key \"signature\"; did you mean \"signatures\"?"},
      {"/signatures/0/field/ofset", 1, "signatures.0.field: unknown key \"ofset\"; did you mean \"offset\"?"},
      {"/signatures/0/field/rays", 25, "signatures.0.field: unknown key \"rays\"; known here: "},
      {"/signatures/0/histogram/bin", 1, "signatures.0.histogram: unknown key \"bin\""},
      {"/dataset/roots", "x", "dataset: unknown key \"roots\""},
      {"/signatures/1/field/type", "conesdf", "signatures.1.field.type: unknown word \"conesdf\""},
      {"/protocol", "pbs", "protocol: unknown word \"pbs\"; did you mean \"psb\"?"},
      {"/protocol", {"psb", "papers"}, "protocol.1: unknown word \"papers\""},
      {"/signatures/0/histogram/range", "pershape", "signatures.0.histogram.range: unknown word \"pershape\""},
      {"/dataset/layout", "modelnet", "known here: \"shrec11\", \"folders\", \"csv\""},
      {"/on_error", 3, "on_error: must be one of \"stop\", \"skip\", not 3"},
      {"/signatures/0/histogram/bins", "80", "signatures.0.histogram.bins: must be of type integer, not string"},
      {"/signatures/0/histogram/bins", 8.5, "must be of type integer, not number"},
      {"/signatures/0/field/offset", true, "must be of type number, not boolean"},
      {"/signatures", Json::object(), "signatures: must be of type array, not object"},
      {"/dataset", 3, "dataset: must be of type object, not number"},
      {"/signatures/0/name", 1, "signatures.0.name: must be of type string, not number"},
      {"/signatures/0/field/offset", 0, "signatures.0.field.offset: must be from 1e-06 to 1, not 0"},
      {"/signatures/0/field/offset", 5, "must be from 1e-06 to 1, not 5"},
      {"/signatures/0/histogram/bins", 0, "must be from 1 to 100000, not 0"},
      {"/seed", -1, "seed: must be from 0 to 9007199254740991, not -1"},
      {"/seed", 1.5, "seed: must be of type integer"},
      {"/seed", 9007199254740992, "seed: must be"},
      {"/signatures", Json::array(), "signatures: "},
      {"/protocol", {"psb", "psb"}, "protocol: "},
      {"/signatures/0/histogram/range", {{"fixed", {0}}}, "signatures.0.histogram.range.fixed: "},
      {"/signatures/0/name", "a\nb", "signatures.0.name: "},
      {"/signatures/0/name", "", "signatures.0.name: must not be empty"}};
  for (const auto& [pointer, value, message] : refusals) {
    EXPECT_THAT(schema_error_with(pointer, value), HasSubstr(message)) << pointer << " = " << value;
  }
  EXPECT_EQ(schema_error_with("/seed", 9007199254740991), "no error");
  EXPECT_THAT(test::input_error_of([] { check(Json::array()); }), HasSubstr("must be of type object, not array"));
}

TEST(SchemaCheck, NamesMissingKeys) {
  EXPECT_EQ(message_without("", "name"), "x.json: the key \"name\" is missing");
  EXPECT_THAT(message_without("/signatures/0/field", "offset"), HasSubstr("signatures.0.field: the key \"offset\""));
  EXPECT_THAT(message_without("/signatures/0", "histogram"), HasSubstr("signatures.0: the key \"histogram\""));
}

/// JSON pointers of all values of a document.
std::vector<std::string> pointers_in(const Json& document) {
  std::vector<std::string> pointers;
  const Json flat = document.flatten();
  for (const auto& item : flat.items()) {
    for (std::size_t end = item.key().size(); end != std::string::npos && end > 0;
         end = item.key().rfind('/', end - 1)) {
      const std::string pointer = item.key().substr(0, end);
      if (std::ranges::find(pointers, pointer) == pointers.end()) pointers.push_back(pointer);
    }
  }
  return pointers;
}

TEST(SchemaCheck, GivesASpecificErrorForEveryViolatedConstraint) {
  Json document = valid();
  document["perturbations"] = Json::parse(R"([{"type": "holes", "radius": 0.1},
                                              {"type": "one_of", "choices": [[], [{"type": "motion"}]]}])");
  document["evaluation"] = {{"measures", {"NN"}}, {"ties", "index"}};
  document["report"]["pictures"]["range"] = {0, 1};
  const std::vector<Json> others{nullptr, true,           -1,        0.5, 1e300, "", "x\ny", Json::array(),
                                 {1, 2},  Json::object(), {{"x", 1}}};
  for (const std::string& pointer : pointers_in(document)) {
    int refused = 0;
    for (const Json& other : others) {
      Json changed = document;
      changed[Json::json_pointer(pointer)] = other;
      const std::string message = test::input_error_of([&] { check(changed); });
      refused += message == "no error" ? 0 : 1;
      EXPECT_THAT(message, Not(HasSubstr("does not match the schema"))) << pointer << " = " << other;
    }
    EXPECT_GE(refused, 7) << pointer;
  }
}

TEST(SchemaCheck, ShortensLongValuesInMessages) {
  const std::string endless(1'000'000, 'x');
  EXPECT_THAT(schema_error_with("/signatures/0/name", endless), Eq("no error"));
  EXPECT_THAT(schema_error_with("/signatures/0/name", endless + "\n"), StartsWith("x.json: signatures.0.name: "));
  EXPECT_LT(schema_error_with("/protocol", endless).size(), 1000U);
  EXPECT_LT(schema_error_with("/signatures/0/histogram/bins", endless).size(), 1000U);
  EXPECT_LT(schema_error_with("/signatures/0/" + endless, 1).size(), 1000U);
}

/// Error message of a part of a configuration.
std::string part_error(const Json& part, const std::string& definition) {
  return test::input_error_of([&] { check_against_schema(part, definition, "part"); });
}

TEST(SchemaCheck, ChecksAPartOfAConfigurationAgainstItsDefinition) {
  EXPECT_EQ(part_error({{"type", "cone_sdf"}, {"rays", 9}}, "field"), "no error");
  EXPECT_EQ(part_error({{"bins", 9}, {"range", "per-shape"}}, "histogram"), "no error");
  EXPECT_THAT(part_error({{"type", "cone_sdf"}, {"ray", 9}}, "field"),
              Eq("part: unknown key \"ray\"; did you mean \"rays\"?"));
  EXPECT_THAT(part_error({{"bins", 0}, {"range", "per-shape"}}, "histogram"), StartsWith("part: bins: must be from 1"));
  EXPECT_THAT(part_error({{"type", "cone_sdf"}}, "histogram"), StartsWith("part: "));
  EXPECT_THAT(part_error(valid(), "field"), StartsWith("part: ")) << "a whole configuration is no field";
  // The same fault has the same message in a part as in the whole, except for its path.
  const Json wrong{{"type", "offset_sdf"}, {"offset", -3}};
  EXPECT_EQ(schema_error_with("/signatures/0/field", wrong),
            "x.json: signatures.0.field." + part_error(wrong, "field").substr(std::string("part: ").size()));
}

TEST(SchemaCheck, AcceptsASchemaThatRefersToSharedDefinitions) {
  const nlohmann::ordered_json schema{{"required", {"count"}},
                                      {"properties", {{"count", {{"$ref", "#/definitions/plain_name"}}}}}};
  const auto error = [&](const Json& document) {
    return test::input_error_of([&] { check_by_schema(document, schema, "own.json"); });
  };
  EXPECT_EQ(error({{"count", "x"}}), "no error");
  EXPECT_EQ(error(Json::object()), "own.json: the key \"count\" is missing");
  EXPECT_EQ(error({{"count", ""}}), "own.json: count: must not be empty");
}

TEST(ExperimentSchema, ContainsFieldTypesRegisteredByUsers) {
  const Json field{{"type", "test_flat"}, {"height", 2}};
  EXPECT_THAT(schema_error_with("/signatures/0/field", field), HasSubstr("unknown word \"test_flat\""));
  field_types().add({.name = "test_flat",
                     .description = "The same everywhere.",
                     .parameters = {{.name = "height", .bounds = {.low = 1, .high = 3}, .description = "Everywhere."}},
                     .make = field_types().at("offset_sdf").make});
  EXPECT_EQ(schema_error_with("/signatures/0/field", field), "no error");
  EXPECT_EQ(
      schema_error_with("/signatures/0/field/type", "test_flat"),
      "x.json: signatures.0.field: unknown key \"offset\"; known here: \"at\", \"bilateral\", \"height\", \"type\"");
  EXPECT_EQ(schema_error_with("/signatures/0/field", {{"type", "test_flat"}, {"height", 4}}),
            "x.json: signatures.0.field.height: must be from 1 to 3, not 4");
}

}  // namespace

}  // namespace shapegauge
