// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "shapegauge/core/base/interruption.h"

/// Interruptible versions of TBB's loops over ranges. A cancelled TBB loop returns normally with partial results; the
/// functions here throw Interrupted instead. They rethrow exceptions of the body.

namespace shapegauge {

/// Calls body(subrange) in parallel for disjoint subranges, chosen by TBB, that cover the range. Throws Interrupted if
/// cancelled.
template <typename Range, typename Body>
void interruptible_parallel_for(const Range& range, const Body& body) {
  tbb::parallel_for(range, body);
  check_interruption();
}

/// Reduces a range in parallel: combines the results of body(subrange, partial value) over subranges chosen by TBB with
/// join(a, b), starting from `identity`. Throws Interrupted if cancelled.
template <typename Range, typename Value, typename Body, typename Join>
Value interruptible_parallel_reduce(const Range& range, const Value& identity, const Body& body, const Join& join) {
  const Value result = tbb::parallel_reduce(range, identity, body, join);
  check_interruption();
  return result;
}

}  // namespace shapegauge
