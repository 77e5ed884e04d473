#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace shapegauge {

/// How whoever starts a run watches and stops it.
struct RunControl {
  int threads = 0;                                           ///< 0: as many as the machine has
  std::function<bool()> interrupted = [] { return false; };  ///< asked between shapes; true: stop soon. Any thread.
  /// Told what is being done and how far it is; one call at a time.
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress =
      [](std::string_view, std::size_t, std::size_t) {};
};

/// A run that was stopped from outside. The message says what is left of it.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(const std::string& message = "interrupted; no results were written")
      : std::runtime_error(message) {}
};

}  // namespace shapegauge
