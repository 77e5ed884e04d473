// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace shapegauge {

/// Exception for interrupted work. The message states what was written before the interruption.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(const std::string& message = "interrupted; no results were written")
      : std::runtime_error(message) {}
};

/// Returns true if the work of the calling thread is cancelled, by a Cancellation or by a failure elsewhere in the same
/// parallel loop. Takes a few nanoseconds.
bool interruption_requested();

/// Throws Interrupted if interruption_requested(). For long serial loops; the loops of parallel.h check on their own.
void check_interruption();

/// Calls check_interruption() in every 4096th call, for loops with very short steps. Not thread-safe.
class SparseInterruptionCheck {
 public:
  void operator()() const {
    if (++steps_ % 4096 == 0) check_interruption();
  }

 private:
  mutable std::uint32_t steps_ = 0;  ///< number of calls so far
};

}  // namespace shapegauge
