#include <gmock/gmock.h>

#include "shapegauge/experiments/configuration/parse_json.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(ParseJson, GivesTheValue) { EXPECT_EQ(parse_json(R"({"a": [1, "x"]})", "x.json")["a"][1], "x"); }

TEST(ParseJson, ASyntaxErrorHasLineAndColumn) {
  const std::string message = input_error_of([] { parse_json("{\n  \"a\": 1\n  \"b\": 2\n}", "x.json"); });
  EXPECT_THAT(message, StartsWith("x.json:3:"));
  EXPECT_THAT(message, HasSubstr("not valid JSON"));
}

TEST(ParseJson, TheColumnPointsIntoTheOffendingLine) {
  EXPECT_THAT(input_error_of([] { parse_json("[1,\n 2,,3]", "x.json"); }), StartsWith("x.json:2:4:"));
}

TEST(ParseJson, TruncatedAndEmptyTexts) {
  EXPECT_THAT(input_error_of([] { parse_json("", "x.json"); }), StartsWith("x.json:1:1: not valid JSON"));
  EXPECT_THAT(input_error_of([] { parse_json("{\"a\": [1,", "x.json"); }), HasSubstr("not valid JSON"));
}

TEST(ParseJson, ANumberTooLargeIsAnError) {
  EXPECT_THAT(input_error_of([] { parse_json("[1e999]", "x.json"); }), StartsWith("x.json: not valid JSON"));
}

TEST(ParseJson, AKeyThatStandsTwiceIsAnError) {
  EXPECT_THAT(input_error_of([] { parse_json(R"({"a": {"b": 1, "c": 2, "b": 3}})", "x.json"); }),
              HasSubstr("the key \"b\" stands twice"));
  EXPECT_NO_THROW(parse_json(R"([{"b": 1}, {"b": {"b": 3}}])", "x.json"));
}

TEST(ParseJson, ValuesNestedTooDeepAreAnError) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_NO_THROW(parse_json(nested(100), "x.json"));
  EXPECT_THAT(input_error_of([&] { parse_json(nested(102), "x.json"); }), HasSubstr("nested more than 100 deep"));
  EXPECT_THAT(input_error_of([&] { parse_json(nested(1'000'000), "x.json"); }), HasSubstr("nested more than 100 deep"));
  EXPECT_THAT(input_error_of([&] { parse_json(std::string(1'000'000, '{'), "x.json"); }), HasSubstr("not valid JSON"));
}

TEST(ParseJson, MessagesAreShort) {
  const std::string word(100'000, 'x');
  EXPECT_LT(input_error_of([&] { parse_json('"' + word, "x.json"); }).size(), 500U);
  EXPECT_LT(input_error_of([&] { parse_json("{\"" + word + "\": 1, \"" + word + "\": 2}", "x.json"); }).size(), 500U);
}

TEST(ParseIfJson, GivesNothingForOtherText) {
  EXPECT_EQ(parse_if_json("[1]", "x").value()[0], 1);
  EXPECT_FALSE(parse_if_json("per-shape", "x").has_value());
  EXPECT_THAT(input_error_of([] { parse_if_json(R"({"a": 1, "a": 2})", "x"); }), HasSubstr("stands twice"));
}

TEST(ReadJson, AnAbsentFileAndAFolderAreErrors) {
  EXPECT_THAT(input_error_of([] { read_json("/nowhere/x.json"); }), StartsWith("/nowhere/x.json: no such file"));
  EXPECT_THAT(input_error_of([] { read_json("/"); }), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace shapegauge
