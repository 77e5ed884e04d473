#pragma once

#include <functional>

#include "shapegauge/experiments/distributed/communicator.h"

namespace shapegauge::test {

/// Runs the work on the given number of ranks, each a thread of this process. Exceptions of ranks are
/// rethrown after all have ended.
void on_thread_ranks(int size, const std::function<void(Communicator&)>& work);

}  // namespace shapegauge::test
