#pragma once

#include <functional>

#include "shapegauge/experiments/distributed/communicator.h"

namespace shapegauge::test {

/// Does the work on so many ranks, each a thread of this process, and waits for all of them. What one of them throws is
/// thrown at the end; the others must end by themselves.
void on_thread_ranks(int size, const std::function<void(Communicator&)>& work);

}  // namespace shapegauge::test
