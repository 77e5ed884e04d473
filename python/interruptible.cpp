#include "python/interruptible.h"

#include <chrono>
#include <future>
#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace shapegauge {

namespace {

constexpr std::chrono::milliseconds between_looks{50};

/// Whether a signal has come whose handler raises; the exception is then the calling thread's.
bool signal_raised() {
  const py::gil_scoped_acquire acquired;
  return PyErr_CheckSignals() != 0;
}

/// Waits for the work, or for a signal; whether a signal came.
bool signal_before_end(const std::future<void>& done) {
  while (done.wait_for(between_looks) != std::future_status::ready) {
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
