// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/retrieval/experiment_results.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shapegauge/metrics/protocol.h"

namespace shapegauge {

namespace {

/// Names the first few models with their reasons.
std::string names_with_reasons(const std::vector<ModelFailure>& failures, const std::vector<Model>& models) {
  constexpr std::size_t most = 3;
  std::vector<std::string> parts;
  for (const ModelFailure& failure : failures) {
    if (parts.size() == most) break;
    parts.push_back(fmt::format("{} ({})", models[failure.model].id, failure.message));
  }
  const std::string others = failures.size() > most ? fmt::format(" and {} more", failures.size() - most) : "";
  return fmt::format("{}{}", fmt::join(parts, ", "), others);
}

/// Describes the effect of ties on FT under each protocol: "FT 52.5 to 81.0 (psb)"; empty if there is none.
std::string effect_on_first_tier(const MethodResults& method) {
  std::vector<std::string> parts;
  for (const Evaluation& evaluation : method.evaluations) {
    const auto& [pessimistic, optimistic] = evaluation.first_tier_bounds;
    if (pessimistic == optimistic) continue;
    parts.push_back(
        fmt::format("{:.1f} to {:.1f} ({})", 100 * pessimistic, 100 * optimistic, name_of(evaluation.protocol)));
  }
  return parts.empty() ? "" : fmt::format("; FT ranges from {} with their order", fmt::join(parts, ", "));
}

}  // namespace

std::vector<std::string> incomplete_methods(const ExperimentResults& results) {
  std::vector<std::string> sentences;
  for (const MethodResults& method : results.methods) {
    if (method.failures.empty()) continue;
    sentences.push_back(fmt::format("method \"{}\" cannot process {} of {} models, which count as not found: {}",
                                    method.name, method.failures.size(), results.models.size(),
                                    names_with_reasons(method.failures, results.models)));
  }
  return sentences;
}

std::vector<std::string> run_warnings(const ExperimentResults& results) {
  std::vector<std::string> warnings = field_warnings(results.fields);
  const auto warn_of = [&](auto affected, std::string_view text) {
    const auto count = std::ranges::count_if(results.shapes, affected);
    if (count > 0) warnings.push_back(fmt::format("{} of {} shapes are clouds {}", count, results.shapes.size(), text));
  };
  if (!results.configuration.preparation.remove_outliers) {
    warn_of([](const ModelDescription& shape) { return shape.diagnostics.outliers > 0; },
            "with outliers, which enlarge them: use `preparation.remove_outliers=true`");
  }
  warn_of([](const ModelDescription& shape) { return shape.diagnostics.stray_normals; },
          "whose normals are not those of the surface: the normals are ignored");
  for (const MethodResults& method : results.methods) {
    if (!method.remark.empty()) warnings.push_back(fmt::format("method \"{}\": {}", method.name, method.remark));
    // Without external ranked lists, all protocols have the same tied queries.
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
