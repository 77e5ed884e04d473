#include <cstdlib>
#include <gmock/gmock.h>

#include "shapegauge/experiments/configuration/expand_variables.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;

class ExpandVariables : public testing::Test {
 protected:
  void SetUp() override {
    setenv("SHAPEGAUGE_TEST_A", "/data", 1);
    setenv("SHAPEGAUGE_TEST_EMPTY", "", 1);
    unsetenv("SHAPEGAUGE_TEST_UNSET");
  }
};

TEST_F(ExpandVariables, ReplacesEach) {
  EXPECT_EQ(expand_variables("no variable, $HOME and {x} are text"), "no variable, $HOME and {x} are text");
  EXPECT_EQ(expand_variables("${SHAPEGAUGE_TEST_A}/x/${SHAPEGAUGE_TEST_A}"), "/data/x//data");
}

TEST_F(ExpandVariables, WhatAVariableHoldsIsNotExpandedAgain) {
  setenv("SHAPEGAUGE_TEST_A", "${SHAPEGAUGE_TEST_UNSET}", 1);
  EXPECT_EQ(expand_variables("${SHAPEGAUGE_TEST_A}"), "${SHAPEGAUGE_TEST_UNSET}");
}

TEST_F(ExpandVariables, AnUnsetVariableIsAnErrorThatSaysToSetIt) {
  for (const std::string name : {"SHAPEGAUGE_TEST_UNSET", "SHAPEGAUGE_TEST_EMPTY"}) {
    const std::string message = input_error_of([&] { expand_variables("${" + name + "}/x"); });
    EXPECT_THAT(message, HasSubstr("variable " + name + " is not set"));
    EXPECT_THAT(message, HasSubstr("export " + name));
  }
}

TEST_F(ExpandVariables, AMissingBraceIsAnError) {
  EXPECT_THAT(input_error_of([] { expand_variables("${SHAPEGAUGE"); }), HasSubstr("without its }"));
}

}  // namespace
}  // namespace shapegauge
