// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/rerank.h"

#include <algorithm>

#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/k_reciprocal.h"
#include "shapegauge/retrieval/query_expansion.h"

namespace shapegauge {

std::vector<int> neighbour_counts(const IntegerList& neighbours) {
  static constexpr IntegerList automatic{4, 5, 7, 10, 14, 20};
  std::vector<int> counts;
  for (const std::int64_t count : (neighbours.empty() ? automatic : neighbours).values()) {
    counts.push_back(static_cast<int>(count));
  }
  std::ranges::sort(counts);
  return counts;
}

Registry<RerankMethod>& rerank_methods() {
  static Registry<RerankMethod> all("re-ranking method",
                                    {diffusion_method(), k_reciprocal_method(), query_expansion_method()},
                                    has_functions<&RerankMethod::rerank>);
  return all;
}

}  // namespace shapegauge
