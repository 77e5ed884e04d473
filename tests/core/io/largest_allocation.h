// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace shapegauge::test {

/// Largest single request to operator new, in bytes, since the last reset. The test program replaces the operator.
std::size_t largest_allocation();
void reset_largest_allocation();

}  // namespace shapegauge::test
