// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/interruptible.h"

#include <chrono>
#include <future>
#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace shapegauge {

namespace {

constexpr std::chrono::milliseconds polling_interval{50};

/// Runs the handlers of pending signals; returns true if one raised, which sets the calling thread's exception.
bool signal_raised() {
  const py::gil_scoped_acquire acquired;
  return PyErr_CheckSignals() != 0;
}

/// Waits for the end of the work or for a signal whose handler raises; returns true for a signal.
bool signal_before_end(const std::future<void>& done) {
  while (done.wait_for(polling_interval) != std::future_status::ready) {
    if (signal_raised()) return true;
  }
  return false;
}

bool is_main_thread() {
  const py::module_ threading = py::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

}  // namespace

void run_interruptibly(Cancellation& cancellation, const std::function<void()>& work) {
  bool stopped = false;
  const bool main_thread = is_main_thread();
  {
    const py::gil_scoped_release released;
    if (!main_thread) return work();
    std::future<void> done = std::async(std::launch::async, work);
    stopped = signal_before_end(done);
    if (!stopped) return done.get();
    cancellation.cancel();
    done.wait();
  }
  throw py::error_already_set();
}

}  // namespace shapegauge
