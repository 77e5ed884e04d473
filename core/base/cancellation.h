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
  /// Runs `work` in the calling thread and TBB arena. Rethrows exceptions of `work`; throws Interrupted after cancel().
  void run(const std::function<void()>& work);

  /// Requests cancellation and returns at once. The loops (parallel.h) and check_interruption() calls inside run() then
  /// throw Interrupted. Thread-safe.
  void cancel();

  [[nodiscard]] bool requested() const { return requested_; }

 private:
  class Registration;

  std::atomic<bool> requested_ = false;
  std::mutex mutex_;
  std::vector<Registration*> running_;
};

}  // namespace shapegauge
