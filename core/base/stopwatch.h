// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <utility>

namespace shapegauge {

/// Measures elapsed seconds with the steady clock.
class Stopwatch {
 public:
  /// Returns the seconds since construction.
  [[nodiscard]] double seconds() const { return between(begin_, Clock::now()); }

  /// Returns the seconds since the previous call, or since construction.
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
