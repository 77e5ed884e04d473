#pragma once

#include <cstddef>
#include <exception>
#include <functional>
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

/// A run that was stopped from outside.
class Interrupted : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

}  // namespace shapegauge
