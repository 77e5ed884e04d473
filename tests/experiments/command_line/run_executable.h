#pragma once

#include <string>

namespace shapegauge::test_command_line {

/// What a call of the program gave.
struct Outcome {
  int status = 0;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs the built executable with the arguments, as a shell reads them, and waits for it. Its cache is empty and its
/// own, unless the arguments name another one.
Outcome run_executable(const std::string& arguments);

}  // namespace shapegauge::test_command_line
