#pragma once

#include <functional>

#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

/// Runs the work without the interpreter's lock, and stops it soon after a signal whose handler raises (Ctrl-C): then
/// throws the Python exception. Only the interpreter's main thread is told of signals; it waits for them while another
/// one works. `cancellation` is what stops the work, which it must run within. Throws what the work throws.
void run_interruptibly(Cancellation& cancellation, const std::function<void()>& work);

}  // namespace shapegauge
