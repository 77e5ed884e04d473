#pragma once

#include <string>
#include <vector>

#include "tests/experiments/command_line/run_executable.h"

namespace shapegauge::test_command_line {

/// Expects what unusable input or arguments give: status 2, one line on standard error that holds the words, and
/// nothing on standard output.
void expect_error_line(const Outcome& outcome, const std::string& words);

/// The arguments of a call that are of no use, and words of its error.
struct UnusableCall {
  std::string arguments;
  std::string words;
};

/// Runs each and expects such an error line.
void expect_error_lines(const std::vector<UnusableCall>& calls);

}  // namespace shapegauge::test_command_line
