// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// Ranked list with a hit at rank i + 1 if hits[i] is true, and further relevant models outside the list.
inline RankedList list_of_hits(const std::vector<bool>& hits, bool starts_with_query = false,
                               std::size_t not_in_list = 0) {
  std::vector<RankRun> runs;
  for (const bool hit : hits) runs.push_back({1, hit ? 1U : 0U});
  return list_of_runs(runs, starts_with_query, not_in_list);
}

}  // namespace shapegauge
