#pragma once

#include <cstddef>
#include <vector>

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// The list in which rank i + 1 is a hit where hits[i] is true, with further relevant models that are not in it.
inline RankedList list_of_hits(const std::vector<bool>& hits, bool starts_with_query = false,
                               std::size_t not_in_list = 0) {
  std::vector<RankRun> runs;
  for (const bool hit : hits) runs.push_back({1, hit ? 1U : 0U});
  return list_of_runs(runs, starts_with_query, not_in_list);
}

}  // namespace shapegauge
