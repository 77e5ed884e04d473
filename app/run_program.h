#pragma once

#include <span>
#include <string>

namespace shapegauge {

/// Exit statuses of the program (the design, section 6).
inline constexpr int exit_success = 0;
inline constexpr int exit_with_failures = 1;   ///< finished, but something failed that the messages name
inline constexpr int exit_unusable_input = 2;  ///< unusable input or arguments
inline constexpr int exit_interrupted = 130;   ///< as shells have it for SIGINT

/// From now on the first Ctrl-C (SIGINT) does not end the program but is remembered; a second one ends it.
void catch_interruption();

/// Whether there was one.
bool interrupted();

/// The program: reads the arguments (without the program's name), does what they say, and returns the exit status: 0
/// for success, 1 for a run that finished with failures it named, 2 for unusable input or arguments, 130 where it was
/// interrupted. Results go to standard output or files; messages and progress to standard error.
int run_program(std::span<const std::string> arguments);

}  // namespace shapegauge
