#pragma once

#include <cstddef>

namespace shapegauge::test {

/// The most bytes that were asked of operator new at once since the last reset. The test program has its own.
std::size_t largest_allocation();
void reset_largest_allocation();

}  // namespace shapegauge::test
