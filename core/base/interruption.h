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

/// Thrown where work is interrupted. The message says what is left behind.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(const std::string& message = "interrupted; no results were written")
      : std::runtime_error(message) {}
};

/// Whether the calling thread's work is cancelled: by a Cancellation, or because another part of the same parallel loop
/// failed. Costs a few nanoseconds.
inline bool interruption_requested() { return tbb::is_current_task_group_canceling(); }

/// Throws Interrupted where interruption_requested(). For long serial loops; those of parallel.h check by themselves.
inline void check_interruption() {
  if (interruption_requested()) throw Interrupted();
}

/// check_interruption() for loops of very short steps: checks at every 4096th call. Not to be shared by threads.
class SparseInterruptionCheck {
 public:
  void operator()() const {
    if (++steps_ % 4096 == 0) check_interruption();
  }

 private:
  mutable std::uint32_t steps_ = 0;
};

/// Lets one thread stop the work of others, as on Ctrl-C.
class Cancellation {
 public:
  /// Runs the work in the calling thread and TBB arena. Throws what the work throws, and Interrupted after cancel().
  void run(const std::function<void()>& work);

  /// Makes run() end soon: its loops (parallel.h) and calls of check_interruption() throw Interrupted. Returns at once.
  /// Can be called from any thread.
  void cancel();

  [[nodiscard]] bool requested() const { return requested_; }

 private:
  class Registration;

  std::atomic<bool> requested_ = false;
  std::mutex mutex_;
  std::vector<tbb::task_group_context*> running_;
};

}  // namespace shapegauge
