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

TEST(ReadJson, AnAbsentFileAndAFolderAreErrors) {
  EXPECT_THAT(input_error_of([] { read_json("/nowhere/x.json"); }), StartsWith("/nowhere/x.json: no such file"));
  EXPECT_THAT(input_error_of([] { read_json("/"); }), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace shapegauge
