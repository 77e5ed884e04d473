// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/derived_distances.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 3> kinds_of_derived{"sum", "fuse_ranks", "rerank"};
constexpr auto sum_parameters = parameters_of(sum_table);
constexpr auto rank_fusion_parameters = parameters_of(rank_fusion_table);

DerivedDistances sum_of(const Json& signature) {
  DerivedDistances derived;
  SumSettings sum{.weights = {}, .options = read_options(sum_table, signature)};
  for (const Json& term : signature.at("sum")) {
    derived.names.push_back(term.at("of"));
    sum.weights.push_back(read_parameters(sum_term_parameters(), term).number("weight"));
  }
  if (std::ranges::all_of(sum.weights, [](double weight) { return weight == 0; })) {
    throw ConfigurationError{"sum", "at least one weight must be positive"};
  }
  derived.settings = std::move(sum);
  return derived;
}

DerivedDistances reranking_of(const Json& settings) {
  const RerankMethod& method = rerank_methods().at(settings.at("method").get<std::string>());
  RerankSettings rerank{.method = &method, .values = read_parameters(method.parameters, settings)};
  if (method.check != nullptr) method.check(rerank.values);
  return {.names = {settings.at("of")}, .settings = std::move(rerank)};
}

}  // namespace

std::span<const std::string_view> derived_keys() { return kinds_of_derived; }

std::span<const Parameter> derived_parameters() {
  static constexpr std::array parameters{sum_parameters[0], sum_parameters[1], rank_fusion_parameters[0]};
  return parameters;
}

std::span<const Parameter> sum_term_parameters() {
  static const std::array parameters{Parameter{.name = "weight",
                                               .default_value = 1.0,
                                               .bounds = {.low = 0, .high = 1e6},
                                               .description = "Factor of the signature's distances in the sum."}};
  return parameters;
}

DerivedDistances make_derived(const std::string& key, const Json& signature) {
  for (const Parameter& parameter : derived_parameters()) {
    const std::string_view belongs_to = parameter.name == "score" ? kinds_of_derived[1] : kinds_of_derived[0];
    if (signature.contains(parameter.name) && key != belongs_to) {
      throw ConfigurationError{parameter.name, fmt::format("requires \"{}\"", belongs_to)};
    }
  }
  if (key == kinds_of_derived[0]) return sum_of(signature);
  if (key == kinds_of_derived[2]) return reranking_of(signature.at(key));
  return {.names = signature.at(key), .settings = read_options(rank_fusion_table, signature)};
}

std::string_view key_of(const DerivedDistances& derived) { return kinds_of_derived.at(derived.settings.index()); }

Json to_json(const DerivedDistances& derived) {
  const std::string key(key_of(derived));
  Json json;
  if (const auto* const sum = std::get_if<SumSettings>(&derived.settings)) {
    json = options_json(sum_table, sum->options);
    for (std::size_t i = 0; i < sum->weights.size(); ++i) {
      json[key].push_back({{"of", derived.names[i]}, {"weight", sum->weights[i]}});
    }
  } else if (const auto* const ranks = std::get_if<RankFusionOptions>(&derived.settings)) {
    json = options_json(rank_fusion_table, *ranks);
    json[key] = derived.names;
  } else {
    const auto& rerank = std::get<RerankSettings>(derived.settings);
    json[key] = to_json(rerank.values);
    json[key].update({{"of", derived.names.front()}, {"method", rerank.method->name}});
  }
  return json;
}

DistanceMatrix derive(const DerivedDistances& derived, std::span<const DistanceMatrix> matrices) {
  if (const auto* const sum = std::get_if<SumSettings>(&derived.settings)) {
    return sum_of_distances(matrices, sum_weights(matrices, sum->weights, sum->options.weights), sum->options.scale);
  }
  if (const auto* const ranks = std::get_if<RankFusionOptions>(&derived.settings)) {
    return fusion_of_ranks(matrices, std::vector<double>(matrices.size(), 1), ranks->score);
  }
  const auto& rerank = std::get<RerankSettings>(derived.settings);
  return rerank.method->rerank(matrices.front(), rerank.values);
}

std::string remark_on(const DerivedDistances& derived, std::span<const DistanceMatrix> matrices) {
  const auto* const sum = std::get_if<SumSettings>(&derived.settings);
  if (sum == nullptr || sum->options.weights != SumWeights::agreement) return {};
  const std::optional<Disagreement> found = find_disagreement(matrices, sum->weights);
  if (!found) return {};
  return fmt::format(
      "\"{}\" and \"{}\" find different groups: they share {:.0f} % of the nearest models, and the neighbours of a "
      "model at least {:.0f} % of theirs. If poses do not count, use a method for articulated shapes",
      derived.names[found->first], derived.names[found->second], 100 * found->agreement, 100 * found->cohesion);
}

}  // namespace shapegauge
