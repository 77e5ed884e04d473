#pragma once

namespace shapegauge {

/// Exit statuses of the program (the design, section 6).
inline constexpr int exit_success = 0;
inline constexpr int exit_with_failures = 1;   ///< finished, but something failed that the messages name
inline constexpr int exit_unusable_input = 2;  ///< unusable input or arguments
inline constexpr int exit_interrupted = 130;   ///< as shells have it for SIGINT

}  // namespace shapegauge
