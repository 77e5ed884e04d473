// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace shapegauge {

void parallel_for_ranges(std::size_t count, const std::function<void(std::size_t begin, std::size_t end)>& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                    [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
  check_interruption();
}

}  // namespace shapegauge
