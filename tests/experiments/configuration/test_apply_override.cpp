#include <gmock/gmock.h>

#include "shapegauge/experiments/configuration/apply_override.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

Json overridden(const std::string& assignment) {
  Json document = Json::parse(R"({"name": "x", "signatures": [{"histogram": {"bins": 80}}, {}]})");
  apply_override(document, assignment);
  return document;
}

TEST(ApplyOverride, ChangesAValueWithinAnArray) {
  EXPECT_EQ(overridden("signatures.0.histogram.bins=40")["signatures"][0]["histogram"]["bins"], 40);
}

TEST(ApplyOverride, TheValueIsJsonOrElseAString) {
  EXPECT_EQ(overridden("name=true")["name"], true);
  EXPECT_EQ(overridden("name=\"true\"")["name"], "true");
  EXPECT_EQ(overridden("name=per-shape")["name"], "per-shape");
  EXPECT_EQ(overridden("name={\"fixed\": [0, 1]}")["name"]["fixed"][1], 1);
  EXPECT_EQ(overridden("name=a=b")["name"], "a=b");
  EXPECT_EQ(overridden("name=")["name"], "");
}

TEST(ApplyOverride, MakesObjectsOnTheWay) {
  EXPECT_EQ(overridden("evaluation.minimum_class_size=3")["evaluation"]["minimum_class_size"], 3);
}

TEST(ApplyOverride, WhatLeadsNowhereIsAnError) {
  EXPECT_THAT(input_error_of([] { overridden("signatures.2.name=x"); }), HasSubstr("\"2\" is not an index"));
  EXPECT_THAT(input_error_of([] { overridden("signatures.-1.name=x"); }), HasSubstr("\"-1\" is not an index"));
  EXPECT_THAT(input_error_of([] { overridden("signatures.first.name=x"); }), HasSubstr("not an index"));
  EXPECT_THAT(input_error_of([] { overridden("name.more=1"); }), HasSubstr("there is no \"more\" in \"x\""));
  EXPECT_THAT(input_error_of([] { overridden("name"); }), HasSubstr("expected dotted.key=value"));
  EXPECT_THAT(input_error_of([] { overridden("=1"); }), HasSubstr("expected dotted.key=value"));
  EXPECT_THAT(input_error_of([] { overridden("a..b=1"); }), HasSubstr("is empty"));
}

TEST(ApplyOverride, WhatNoConfigurationCanHoldIsAnError) {
  EXPECT_THAT(input_error_of([] { overridden("name=\xFF"); }), HasSubstr("not UTF-8"));
  EXPECT_THAT(input_error_of([] { overridden("na\xC3me=x"); }), HasSubstr("not UTF-8"));
  EXPECT_THAT(input_error_of([] { overridden("name=" + std::string(200, '[') + std::string(200, ']')); }),
              HasSubstr("nested more than 100 deep"));
  EXPECT_THAT(input_error_of([] { overridden(R"(name={"a": 1, "a": 2})"); }), HasSubstr("stands twice"));
  std::string deep = "a";
  for (int i = 0; i < 100; ++i) deep += ".a";
  EXPECT_THAT(input_error_of([&] { overridden(deep + "=1"); }), HasSubstr("more than 100 keys"));
}

}  // namespace
}  // namespace shapegauge
