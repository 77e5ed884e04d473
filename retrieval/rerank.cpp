#include "shapegauge/retrieval/rerank.h"

#include <algorithm>
#include <array>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/k_reciprocal.h"
#include "shapegauge/retrieval/query_expansion.h"

namespace shapegauge {

std::vector<int> neighbour_counts(const IntegerList& neighbours, Eigen::Index models) {
  static constexpr IntegerList automatic{4, 5, 7, 10, 14, 20};
  std::vector<int> counts;
  for (const std::int64_t count : (neighbours.empty() ? automatic : neighbours).values()) {
    counts.push_back(static_cast<int>(count));
  }
  (void)models;
  std::ranges::sort(counts);
  return counts;
}

std::span<const RerankMethod> rerank_methods() {
  static const std::array methods{diffusion_method(), k_reciprocal_method(), query_expansion_method()};
  return methods;
}

const RerankMethod& rerank_method(std::string_view name) {
  const auto methods = rerank_methods();
  const auto found = std::ranges::find(methods, name, &RerankMethod::name);
  if (found != methods.end()) return *found;
  std::string message = "there is no way to re-rank named \"" + std::string(name) + "\"; known are:";
  for (const RerankMethod& one : methods) message.append(" ").append(one.name);
  throw InputError(message);
}

}  // namespace shapegauge
