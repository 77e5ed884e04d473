#pragma once

#include <functional>

namespace shapegauge {

/// Number of threads that 0 stands for: what the machine has.
int available_threads();

/// Runs the work with at most so many threads (0: available_threads()), its own included.
void with_threads(int threads, const std::function<void()>& work);

}  // namespace shapegauge
