// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string_view>

#include "shapegauge/experiments/configuration/parameter_json.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

constexpr std::array<std::string_view, 2> colours{"red", "blue"};
constexpr std::array<std::string_view, 1> automatic{"auto"};

const std::vector<Parameter> parameters{
    {.name = "width", .bounds = {.low = 0, .high = 2.5, .low_open = true}, .choices = automatic, .description = "W."},
    {.name = "count",
     .kind = ParameterKind::integer,
     .default_value = std::int64_t{7},
     .bounds = {.low = 1},
     .description = "C."},
    {.name = "open", .kind = ParameterKind::boolean, .default_value = true, .description = "O."},
    {.name = "colour",
     .kind = ParameterKind::choice,
     .default_value = colours[1],
     .choices = colours,
     .description = "Of the lid."}};

TEST(ParameterJson, FillsInDefaultsAndIsReadBackAsWritten) {
  const Json filled = to_json(read_parameters(parameters, {{"width", 2}, {"count", 3}, {"other", "ignored"}}));
  EXPECT_EQ(filled, Json::parse(R"({"width": 2.0, "count": 3, "open": true, "colour": "blue"})"));
  EXPECT_TRUE(filled["width"].is_number_float()) << "a number is one however it was written";
  EXPECT_EQ(to_json(read_parameters(parameters, filled)), filled);
  EXPECT_EQ(read_parameters(parameters, {{"width", "auto"}}).word("width"), "auto");
}

/// A parameter whose values are lists.
const std::vector<Parameter> listed{{.name = "sizes",
                                     .kind = ParameterKind::integers,
                                     .default_value = IntegerList{3},
                                     .bounds = {.low = 1, .high = 9},
                                     .choices = automatic,
                                     .description = "S."}};

TEST(ParameterJson, AcceptsANumberAListOrAWordForAListParameter) {
  for (const Json& sizes : {Json(4), Json({4, 9, 1}), Json("auto")}) {
    EXPECT_EQ(to_json(read_parameters(listed, {{"sizes", sizes}})).at("sizes"), sizes);
  }
  EXPECT_EQ(to_json(read_parameters(listed, {{"sizes", Json::array({4})}})).at("sizes"), 4);
  EXPECT_EQ(to_json(read_parameters(listed, Json::object())).at("sizes"), 3);
  for (const Json& sizes :
       {Json(0), Json::array(), Json({4, 10}), Json({4, 1.5}), Json(std::vector<int>(17, 4)), Json("all")}) {
    EXPECT_THAT(test::input_error_of([&] { read_parameters(listed, {{"sizes", sizes}}); }), HasSubstr("sizes is"));
  }
  EXPECT_EQ(Json(schema_of(listed[0])), Json::parse(R"({"description": "S.", "if": {"type": "string"},
      "then": {"enum": ["auto"]}, "else": {"if": {"type": "array"},
        "then": {"minItems": 1, "maxItems": 16, "items": {"type": "integer", "minimum": 1, "maximum": 9}},
        "else": {"type": "integer", "minimum": 1, "maximum": 9}}, "default": 3})"));
}

TEST(ParameterJson, RejectsMissingKeysWrongTypesAndValuesOutOfBounds) {
  const auto message = [](const Json& settings) {
    return test::input_error_of([&] { read_parameters(parameters, settings); });
  };
  const std::vector<std::pair<Json, const char*>> refusals = {
      {Json::object(), "width is missing"},
      {{{"width", 0}}, "width is 0"},
      {{{"width", 2.6}}, "width is 2.6"},
      {{{"width", "wide"}}, "width is"},
      {{{"width", 1}, {"count", 0}}, "count is 0"},
      {{{"width", 1}, {"count", 1.5}}, "count is 1.5"},
      {{{"width", 1}, {"count", 18446744073709551615U}}, "count is 1.8"},  // not a negative number
      {{{"width", 1}, {"open", 1}}, "open is 1"},
      {{{"width", 1}, {"colour", "green"}}, "colour is"},
      {{{"width", Json::array({1})}}, "width is"}};
  for (const auto& [settings, word] : refusals) EXPECT_THAT(message(settings), HasSubstr(word)) << settings;
}

TEST(ParameterJson, SchemaHasTypesBoundsChoicesAndDefaults) {
  EXPECT_EQ(Json(schema_of(parameters[0])), Json::parse(R"({"description": "W.", "if": {"type": "string"},
      "then": {"enum": ["auto"]}, "else": {"type": "number", "exclusiveMinimum": 0, "maximum": 2.5}})"));
  EXPECT_EQ(Json(schema_of(parameters[1])),
            Json::parse(R"({"description": "C.", "type": "integer", "minimum": 1, "default": 7})"));
  EXPECT_EQ(Json(schema_of(parameters[2])),
            Json::parse(R"({"description": "O.", "type": "boolean", "default": true})"));
  EXPECT_EQ(Json(schema_of(parameters[3])),
            Json::parse(R"({"description": "Of the lid.", "enum": ["red", "blue"], "default": "blue"})"));
}

TEST(ParameterJson, SchemaStatesTheUnit) {
  const std::vector<Parameter> angle{{.name = "angle", .bounds = {.low = 0}, .description = "A.", .unit = "turns"}};
  EXPECT_EQ(Json(schema_of(angle[0])).at("description"), "A. Unit: turns.");
}

}  // namespace

}  // namespace shapegauge
