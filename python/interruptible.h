// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "shapegauge/core/base/cancellation.h"

namespace shapegauge {

/// Runs `work` with the lock of the Python interpreter (GIL) released. If a signal handler raises (Ctrl-C), stops the
/// work and throws the Python exception. Only the main thread of the interpreter receives signals: it waits for them
/// while another thread works. Calls from other threads are not interrupted. `work` must run within `cancellation`
/// (Cancellation::run()). Rethrows the exceptions of `work`.
void run_interruptibly(Cancellation& cancellation, const std::function<void()>& work);

}  // namespace shapegauge
