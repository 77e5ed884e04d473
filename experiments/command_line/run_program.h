#pragma once

#include <span>
#include <string>

namespace shapegauge {

/// The program: reads the arguments (without the program's name), does what they say, and returns the exit status: 0
/// for success, 1 for a run that finished with failures it named, 2 for unusable input or arguments, 130 where it was
/// interrupted. Results go to standard output or files; messages and progress to standard error.
int run_program(std::span<const std::string> arguments);

}  // namespace shapegauge
