#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "shapegauge/core/base/interruption.h"

/// Interruptible versions of TBB's loops. A cancelled TBB loop returns normally with partial results; these throw
/// Interrupted.

namespace shapegauge {

/// Calls body(i) for each index in [first, last), in parallel in the calling TBB arena. Rethrows exceptions of the
/// body; throws Interrupted.
template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body) {
  if (!(first < last)) return;
  tbb::parallel_for(tbb::blocked_range<Index>(first, last), [&](const tbb::blocked_range<Index>& range) {
    for (Index i = range.begin(); i < range.end() && !interruption_requested(); ++i) body(i);
  });
  check_interruption();
}

/// Calls body(i) for each index, in parallel or serially. Throws like parallel_for().
template <typename Index, typename Body>
void for_each_index(bool parallel, Index first, Index last, const Body& body) {
  if (parallel) return parallel_for(first, last, body);
  for (Index i = first; i < last; ++i) {
    check_interruption();
    body(i);
  }
}

/// Calls body(subrange) for subranges chosen by TBB. Throws like parallel_for().
template <typename Range, typename Body>
void parallel_for_parts(const Range& range, const Body& body) {
  tbb::parallel_for(range, body);
  check_interruption();
}

/// Combines the results of body(subrange, partial value) over subranges chosen by TBB. Throws like parallel_for().
template <typename Range, typename Value, typename Body, typename Join>
Value parallel_reduce_parts(const Range& range, const Value& identity, const Body& body, const Join& join) {
  const Value result = tbb::parallel_reduce(range, identity, body, join);
  check_interruption();
  return result;
}

}  // namespace shapegauge
