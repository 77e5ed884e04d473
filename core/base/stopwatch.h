#pragma once

#include <chrono>
#include <utility>

namespace shapegauge {

/// Measures seconds by the steady clock, from its construction on.
class Stopwatch {
 public:
  /// Since the beginning.
  [[nodiscard]] double seconds() const { return between(begin_, Clock::now()); }

  /// Since the last call, or since the beginning.
  double lap() {
    const Clock::time_point now = Clock::now();
    return between(std::exchange(last_, now), now);
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  }

  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
};

}  // namespace shapegauge
