#include "shapegauge/retrieval/rerank.h"

#include <algorithm>
#include <array>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/k_reciprocal.h"
#include "shapegauge/retrieval/query_expansion.h"

namespace shapegauge {

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
