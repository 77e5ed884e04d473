// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

namespace shapegauge {

/// Cancels work from another thread, for example on Ctrl-C.
class Cancellation {
 public:
  /// Runs `work` in the calling thread and TBB arena. Rethrows exceptions of `work`; throws Interrupted if cancel() was
  /// called before or meanwhile.
  void run(const std::function<void()>& work);

  /// Requests cancellation and returns at once. The loops (parallel.h) and check_interruption() calls inside run() then
  /// throw Interrupted. Thread-safe.
  void cancel();

  /// Returns true once cancel() was called.
  [[nodiscard]] bool requested() const { return requested_; }

 private:
  class Registration;

  std::atomic<bool> requested_ = false;  ///< true once cancel() was called
  std::mutex mutex_;
  std::vector<Registration*> running_;  ///< calls of run() in progress
};

}  // namespace shapegauge
