#pragma once

#include <functional>

#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

/// Runs the work without the interpreter's lock. After a signal whose handler raises (Ctrl-C), stops it and throws the
/// Python exception. Only the interpreter's main thread receives signals: it waits for them while another thread works;
/// calls from other threads are not interrupted. The work must run within `cancellation` (Cancellation::run()). Throws
/// what the work throws.
void run_interruptibly(Cancellation& cancellation, const std::function<void()>& work);

}  // namespace shapegauge
