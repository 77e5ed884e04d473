#include "shapegauge/experiments/runner/run_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shapegauge/metrics/protocol.h"

namespace shapegauge {

namespace {

/// The effect of ties on FT under each protocol: "FT 52.5 to 81.0 (psb)"; empty where there is none.
std::string effect_on_first_tier(const MethodResults& method) {
  std::vector<std::string> parts;
  for (const Evaluation& evaluation : method.evaluations) {
    const auto& [pessimistic, optimistic] = evaluation.first_tier_bounds;
    if (pessimistic == optimistic) continue;
    parts.push_back(
        fmt::format("{:.1f} to {:.1f} ({})", 100 * pessimistic, 100 * optimistic, name_of(evaluation.protocol)));
  }
  return parts.empty() ? "" : fmt::format("; FT is {} by their order", fmt::join(parts, ", "));
}

}  // namespace

std::vector<std::string> run_warnings(const ExperimentResults& results) {
  std::vector<std::string> warnings = field_warnings(results.fields);
  for (const MethodResults& method : results.methods) {
    // Without ranked lists from elsewhere, all protocols have the same tied queries.
    const Evaluation& evaluation = method.evaluations.front();
    if (evaluation.queries_with_ties == 0) continue;
    warnings.push_back(fmt::format(
        "method \"{}\": {} of {} queries have relevant and other models at equal distance, ordered by \"ties\": "
        "\"{}\"{}",
        method.name, evaluation.queries_with_ties, evaluation.queries.size(), name_of(evaluation.ties),
        effect_on_first_tier(method)));
  }
  return warnings;
}

}  // namespace shapegauge
