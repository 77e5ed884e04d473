#include "shapegauge/experiments/configuration/derived_distances.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/retrieval/fusion.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 3> kinds_of_derived{"sum", "fuse_ranks", "rerank"};
constexpr auto sum_parameters = parameters_of(sum_table);
constexpr auto rank_fusion_parameters = parameters_of(rank_fusion_table);

/// Describes two terms of a sum that find different groups; empty if there are none.
std::string disagreement_remark(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                std::span<const std::string> names) {
  const std::optional<Disagreement> found = find_disagreement(matrices, weights);
  if (!found) return {};
  return fmt::format(
      "\"{}\" and \"{}\" find different groups: they share {:.0f} % of the nearest models, and the neighbours of a "
      "model at least {:.0f} % of theirs. If poses do not count, use a method for articulated shapes",
      names[found->first], names[found->second], 100 * found->agreement, 100 * found->cohesion);
}

DerivedDistances sum_of(const Json& signature) {
  DerivedDistances derived{.key = "sum", .settings = Json::object(), .names = {}, .compute = {}};
  std::vector<double> weights;
  for (const Json& term : signature.at("sum")) {
    const double weight = read_parameters(sum_term_parameters(), term).number("weight");
    derived.names.push_back(term.at("of"));
    weights.push_back(weight);
    derived.settings["sum"].push_back({{"of", derived.names.back()}, {"weight", weight}});
  }
  if (std::ranges::all_of(weights, [](double weight) { return weight == 0; })) {
    throw ConfigurationError{"sum", "at least one weight must be positive"};
  }
  const auto options = read_options(sum_table, signature);
  derived.settings.update(options_json(sum_table, options));
  derived.compute = [weights, options](std::span<const DistanceMatrix> matrices) {
    return sum_of_distances(matrices, sum_weights(matrices, weights, options.weights), options.scale);
  };
  if (options.weights == SumWeights::agreement) {
    derived.remark = [weights, names = derived.names](std::span<const DistanceMatrix> matrices) {
      return disagreement_remark(matrices, weights, names);
    };
  }
  return derived;
}

DerivedDistances rank_fusion_of(const Json& signature) {
  const auto options = read_options(rank_fusion_table, signature);
  DerivedDistances derived{.key = "fuse_ranks",
                           .settings = options_json(rank_fusion_table, options),
                           .names = signature.at("fuse_ranks"),
                           .compute = {}};
  derived.settings["fuse_ranks"] = derived.names;
  derived.compute = [options](std::span<const DistanceMatrix> matrices) {
    return fusion_of_ranks(matrices, std::vector<double>(matrices.size(), 1), options.score);
  };
  return derived;
}

DerivedDistances reranking_of(const Json& signature) {
  const Json& settings = signature.at("rerank");
  const RerankMethod& method = rerank_methods().at(settings.at("method").get<std::string>());
  const ParameterValues values = read_parameters(method.parameters, settings);
  method.rerank(DistanceMatrix::Zero(1, 1), values);  // reports inconsistent settings before a run
  Json filled = to_json(values);
  filled["of"] = settings.at("of");
  filled["method"] = method.name;
  return {.key = "rerank",
          .settings = {{"rerank", std::move(filled)}},
          .names = {settings.at("of")},
          .compute = [&method, values](std::span<const DistanceMatrix> matrices) {
            return method.rerank(matrices.front(), values);
          }};
}

}  // namespace

SumSettings sum_settings(const DerivedDistances& sum) {
  SumSettings settings{.weights = {}, .options = read_options(sum_table, sum.settings)};
  for (const Json& term : sum.settings.at("sum")) settings.weights.push_back(term.at("weight"));
  return settings;
}

std::span<const std::string_view> derived_keys() { return kinds_of_derived; }

std::span<const Parameter> derived_parameters() {
  static constexpr std::array parameters{sum_parameters[0], sum_parameters[1], rank_fusion_parameters[0]};
  return parameters;
}

std::span<const Parameter> sum_term_parameters() {
  static const std::array parameters{Parameter{.name = "weight",
                                               .default_value = 1.0,
                                               .bounds = {.low = 0, .high = 1e6},
                                               .description = "Factor of its distances."}};
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
  return key == kinds_of_derived[1] ? rank_fusion_of(signature) : reranking_of(signature);
}

}  // namespace shapegauge
