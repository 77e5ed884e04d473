// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <exception>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/json_document.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(ParseJson, ParsesNestedObjectsAndArrays) { EXPECT_EQ(parse_json(R"({"a": [1, "x"]})", "x.json")["a"][1], "x"); }

TEST(ParseJson, SkipsComments) {
  EXPECT_EQ(parse_json("// one\n{/* two */ \"a\": 1 // three\n}", "x.json"), nlohmann::json({{"a", 1}}));
  EXPECT_THAT(test::input_error_of([] { parse_json("/* one\n*/ {,}", "x.json"); }), StartsWith("x.json:2:"));
}

TEST(ParseJson, RejectsInvalidJsonWithItsPosition) {
  test::expect_refused({{"{\n  \"a\": 1\n  \"b\": 2\n}", "x.json:3:"},
                        {"[1,\n 2,,3]", "x.json:2:4: not valid JSON"},
                        {"", "x.json:1:1: not valid JSON"},
                        {"{\"a\": [1,", "not valid JSON"},
                        {"[1e999]", "x.json: not valid JSON"},
                        {R"({"a": {"b": 1, "c": 2, "b": 3}})", "x.json: the key \"b\" is repeated"}},
                       [](const std::string& text) { parse_json(text, "x.json"); });
  EXPECT_NO_THROW(parse_json(R"([{"b": 1}, {"b": {"b": 3}}])", "x.json"));
}

TEST(ParseJson, RejectsDeeplyNestedValues) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_NO_THROW(parse_json(nested(100), "x.json"));
  EXPECT_THAT(test::input_error_of([&] { parse_json(nested(102), "x.json"); }),
              HasSubstr("nested deeper than 100 levels"));
  EXPECT_THAT(test::input_error_of([&] { parse_json(nested(1'000'000), "x.json"); }),
              HasSubstr("nested deeper than 100 levels"));
  EXPECT_THAT(test::input_error_of([&] { parse_json(std::string(1'000'000, '{'), "x.json"); }),
              HasSubstr("not valid JSON"));
}

TEST(ParseJson, KeepsErrorMessagesShortForLongInput) {
  const std::string word(100'000, 'x');
  EXPECT_LT(test::input_error_of([&] { parse_json('"' + word, "x.json"); }).size(), 500U);
  EXPECT_LT(test::input_error_of([&] { parse_json("{\"" + word + "\": 1, \"" + word + "\": 2}", "x.json"); }).size(),
            500U);
}

TEST(ParseIfJson, ReturnsNothingForTextThatIsNotJson) {
  EXPECT_EQ(parse_if_json("[1]", "x").value()[0], 1);
  EXPECT_FALSE(parse_if_json("per-shape", "x").has_value());
  EXPECT_THAT(test::input_error_of([] { parse_if_json(R"({"a": 1, "a": 2})", "x"); }), HasSubstr("is repeated"));
}

TEST(ReadJson, RejectsAMissingFileAndAFolder) {
  EXPECT_THAT(test::input_error_of([] { read_json("/nowhere/x.json"); }), StartsWith("/nowhere/x.json: no such file"));
  EXPECT_THAT(test::input_error_of([] { read_json("/"); }), HasSubstr("cannot be read"));
}

class ExpandVariables : public testing::Test {
 protected:
  void SetUp() override {
    setenv("SHAPEGAUGE_TEST_A", "/data", 1);
    setenv("SHAPEGAUGE_TEST_EMPTY", "", 1);
    unsetenv("SHAPEGAUGE_TEST_UNSET");
  }
};

TEST_F(ExpandVariables, ReplacesEachEnvironmentVariable) {
  EXPECT_EQ(expand_variables("no variable, $HOME and {x} are text"), "no variable, $HOME and {x} are text");
  EXPECT_EQ(expand_variables("${SHAPEGAUGE_TEST_A}/x/${SHAPEGAUGE_TEST_A}"), "/data/x//data");
}

TEST_F(ExpandVariables, DoesNotExpandVariablesWithinVariableValues) {
  setenv("SHAPEGAUGE_TEST_A", "${SHAPEGAUGE_TEST_UNSET}", 1);
  EXPECT_EQ(expand_variables("${SHAPEGAUGE_TEST_A}"), "${SHAPEGAUGE_TEST_UNSET}");
}

TEST_F(ExpandVariables, ReportsAnUnsetVariable) {
  for (const std::string name : {"SHAPEGAUGE_TEST_UNSET", "SHAPEGAUGE_TEST_EMPTY"}) {
    const std::string message = test::input_error_of([&] { expand_variables("${" + name + "}/x"); });
    EXPECT_THAT(message, HasSubstr("variable " + name + " is not set"));
    EXPECT_THAT(message, HasSubstr("export " + name));
  }
}

TEST_F(ExpandVariables, RejectsAVariableWithoutClosingBrace) {
  EXPECT_THAT(test::input_error_of([] { expand_variables("${SHAPEGAUGE"); }), HasSubstr("without its }"));
}

using Json = nlohmann::json;

Json overridden(const std::string& assignment) {
  Json document = Json::parse(R"({"name": "x", "signatures": [{"histogram": {"bins": 80}}, {}]})");
  apply_override(document, assignment);
  return document;
}

TEST(ApplyOverride, ChangesAValueWithinAnArray) {
  EXPECT_EQ(overridden("signatures.0.histogram.bins=40")["signatures"][0]["histogram"]["bins"], 40);
}

TEST(ApplyOverride, FindsArrayElementsByNameInBrackets) {
  Json document = Json::parse(R"({"signatures": [{"name": "a=b. c"}, {"name": "Sum", "scale": "none"}]})");
  apply_override(document, R"(signatures["Sum"].scale=local)");
  EXPECT_EQ(document["signatures"][1]["scale"], "local");
  apply_override(document, "signatures[Sum].scale=median");
  EXPECT_EQ(document["signatures"][1]["scale"], "median");
  apply_override(document, R"(signatures["a=b. c"].deep.key=1)");
  EXPECT_EQ(document["signatures"][0]["deep"]["key"], 1);
  apply_override(document, "signatures[1].scale=local");
  EXPECT_EQ(document["signatures"][1]["scale"], "local");
  for (const char* wrong : {"signatures[Summ].scale=1", "signatures[Sum.scale=1", "signatures[Sum]scale=1", "[]=1"}) {
    EXPECT_THROW(apply_override(document, wrong), InputError) << wrong;
  }
  const std::string message = test::input_error_of([&] { apply_override(document, "signatures[Summ].scale=1"); });
  EXPECT_THAT(message, HasSubstr("Sum"));
}

TEST(ApplyOverride, ParsesValuesAsJsonOrStrings) {
  EXPECT_EQ(overridden("name=true")["name"], true);
  EXPECT_EQ(overridden("name=\"true\"")["name"], "true");
  EXPECT_EQ(overridden("name=per-shape")["name"], "per-shape");
  EXPECT_EQ(overridden("name={\"fixed\": [0, 1]}")["name"]["fixed"][1], 1);
  EXPECT_EQ(overridden("name=a=b")["name"], "a=b");
  EXPECT_EQ(overridden("name=")["name"], "");
}

TEST(ApplyOverride, CreatesMissingObjectsAlongThePath) {
  EXPECT_EQ(overridden("evaluation.minimum_class_size=3")["evaluation"]["minimum_class_size"], 3);
}

TEST(ApplyOverride, RejectsUnknownPathsAndInvalidText) {
  std::string deep = "a";
  for (int i = 0; i < 100; ++i) deep += ".a";
  test::expect_refused({{"signatures.2.name=x", "\"2\" is not an index"},
                        {"signatures.-1.name=x", "\"-1\" is not an index"},
                        {"signatures.first.name=x", "not an index"},
                        {"name.more=1", "no key \"more\" in \"x\""},
                        {"name", "dotted.key=value"},
                        {"=1", "dotted.key=value"},
                        {"a..b=1", "is empty"},
                        {"name=\xFF", "not UTF-8"},
                        {"na\xC3me=x", "not UTF-8"},
                        {"name=" + std::string(200, '[') + std::string(200, ']'), "deeper than 100"},
                        {R"(name={"a": 1, "a": 2})", "is repeated"},
                        {deep + "=1", "more than 100 keys"}},
                       overridden);
}

TEST(ConfigurationError, MessageBeginsWithThePathOfTheInvalidKey) {
  try {
    at_key("signatures", [] { at_key("0", [] { throw InputError("bins is 0"); }); });
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_STREQ(error.what(), "signatures.0: bins is 0");
  }
  const std::string message =
      test::input_error_of([] { at_key("a", [] { throw ConfigurationError("b", "the fault"); }); });
  EXPECT_EQ(message, "a.b: the fault");
}

}  // namespace

}  // namespace shapegauge
