// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "shapegauge/core/base/cancellation.h"

namespace shapegauge {

/// Runs the work without the interpreter's lock. If a signal handler raises (Ctrl-C), stops the work and throws the
/// Python exception. Only the interpreter's main thread receives signals: it waits for them while another thread works.
/// Calls from other threads are not interrupted. The work must run within `cancellation` (Cancellation::run()).
/// Rethrows the work's exceptions.
void run_interruptibly(Cancellation& cancellation, const std::function<void()>& work);

}  // namespace shapegauge
