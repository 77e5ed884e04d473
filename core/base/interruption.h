#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <tbb/task_group.h>
#include <vector>

namespace shapegauge {

/// Exception for interrupted work. The message states what was left behind.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(const std::string& message = "interrupted; no results were written")
      : std::runtime_error(message) {}
};

/// Returns true if the work of the calling thread is cancelled, by a Cancellation or by a failure elsewhere in the same
/// parallel loop. Takes a few nanoseconds.
inline bool interruption_requested() { return tbb::is_current_task_group_canceling(); }

/// Throws Interrupted if interruption_requested(). For long serial loops; the loops of parallel.h check on their own.
inline void check_interruption() {
  if (interruption_requested()) throw Interrupted();
}

/// Calls check_interruption() in every 4096th call, for loops with very short steps. Not thread-safe.
class SparseInterruptionCheck {
 public:
  void operator()() const {
    if (++steps_ % 4096 == 0) check_interruption();
  }

 private:
  mutable std::uint32_t steps_ = 0;
};

/// Cancels work from another thread, for example on Ctrl-C.
class Cancellation {
 public:
  /// Runs the work in the calling thread and TBB arena. Rethrows its exceptions; throws Interrupted after cancel().
  void run(const std::function<void()>& work);

  /// Requests cancellation and returns at once. The loops (parallel.h) and check_interruption() calls inside run() then
  /// throw Interrupted. Thread-safe.
  void cancel();

  [[nodiscard]] bool requested() const { return requested_; }

 private:
  class Registration;

  std::atomic<bool> requested_ = false;
  std::mutex mutex_;
  std::vector<tbb::task_group_context*> running_;
};

}  // namespace shapegauge
