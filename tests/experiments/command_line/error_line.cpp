#include "tests/experiments/command_line/error_line.h"

#include <gmock/gmock.h>

namespace shapegauge::test_command_line {

void expect_error_line(const Outcome& outcome, const std::string& words) {
  EXPECT_EQ(outcome.status, 2) << words;
  EXPECT_EQ(outcome.output, "") << words;
  EXPECT_THAT(outcome.errors, testing::MatchesRegex("shapegauge: error: [^\n]*\n"));
  EXPECT_THAT(outcome.errors, testing::HasSubstr(words));
}

void expect_error_lines(const std::vector<UnusableCall>& calls) {
  for (const auto& [arguments, words] : calls) {
    SCOPED_TRACE(arguments);
    expect_error_line(run_executable(arguments), words);
  }
}

}  // namespace shapegauge::test_command_line
