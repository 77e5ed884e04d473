// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "shapegauge/core/base/interruption.h"

/// Interruptible loops over indices. Loops over ranges, and reductions, are in parallel_parts.h.

namespace shapegauge {

/// Calls body(begin, end) for disjoint index ranges [begin, end) that cover [0, count), in parallel in the calling TBB
/// arena. Rethrows exceptions of the body; throws Interrupted if the work is cancelled.
void parallel_for_ranges(std::size_t count, const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Calls body(i) for each index in [first, last), in parallel. Throws like parallel_for_ranges().
template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body) {
  if (!(first < last)) return;
  parallel_for_ranges(static_cast<std::size_t>(last - first), [&](std::size_t begin, std::size_t end) {
    const Index range_last = first + static_cast<Index>(end);
    for (Index i = first + static_cast<Index>(begin); i < range_last && !interruption_requested(); ++i) body(i);
  });
}

/// Calls body(i) for each index in [first, last), in parallel or, if `parallel` is false, in order. Throws like
/// parallel_for_ranges().
template <typename Index, typename Body>
void for_each_index(bool parallel, Index first, Index last, const Body& body) {
  if (parallel) return parallel_for(first, last, body);
  for (Index i = first; i < last; ++i) {
    check_interruption();
    body(i);
  }
}

}  // namespace shapegauge
