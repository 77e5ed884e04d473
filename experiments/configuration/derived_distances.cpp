#include "shapegauge/experiments/configuration/derived_distances.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>

#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/retrieval/fusion.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 3> kinds_of_derived{"sum", "fuse_ranks", "rerank"};
constexpr std::array<std::string_view, 5> distance_scales{"median", "mean", "none", "local", "local_spread"};
constexpr std::array<std::string_view, 2> weight_kinds{"given", "agreement"};
constexpr std::array<std::string_view, 2> rank_scores{"reciprocal", "borda"};

DistanceScale scale_of(std::string_view word) {
  if (word == "none") return DistanceScale::none;
  if (word == "local") return DistanceScale::local;
  if (word == "local_spread") return DistanceScale::local_spread;
  return word == "mean" ? DistanceScale::mean : DistanceScale::median;
}

SumWeights weights_of(std::string_view word) { return word == "agreement" ? SumWeights::agreement : SumWeights::given; }

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
  const ParameterValues values = read_parameters(derived_parameters(), signature);
  for (const char* setting : {"scale", "weights"}) derived.settings[setting] = values.word(setting);
  derived.compute = [settings = sum_settings(derived)](std::span<const DistanceMatrix> matrices) {
    return sum_of_distances(matrices, sum_weights(matrices, settings.weights, settings.kind), settings.scale);
  };
  return derived;
}

DerivedDistances rank_fusion_of(const Json& signature) {
  const std::string_view score = read_parameters(derived_parameters(), signature).word("score");
  DerivedDistances derived{.key = "fuse_ranks",
                           .settings = {{"fuse_ranks", signature.at("fuse_ranks")}, {"score", score}},
                           .names = signature.at("fuse_ranks"),
                           .compute = {}};
  derived.compute = [score = score == "borda" ? RankScore::borda
                                              : RankScore::reciprocal](std::span<const DistanceMatrix> matrices) {
    return fusion_of_ranks(matrices, std::vector<double>(matrices.size(), 1), score);
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
  SumSettings settings{.weights = {},
                       .kind = weights_of(sum.settings.at("weights").get<std::string>()),
                       .scale = scale_of(sum.settings.at("scale").get<std::string>())};
  for (const Json& term : sum.settings.at("sum")) settings.weights.push_back(term.at("weight"));
  return settings;
}

std::span<const std::string_view> derived_keys() { return kinds_of_derived; }

std::span<const Parameter> derived_parameters() {
  static const std::array parameters{
      Parameter{.name = "scale",
                .kind = ParameterKind::choice,
                .default_value = distance_scales[0],
                .choices = distance_scales,
                .description = "With sum: divisor of each signature's distances. median, mean: over all pairs of "
                               "models; local: the two models' mean distances to their ten nearest; local_spread: as "
                               "local, then the interquartile range of the result."},
      Parameter{
          .name = "weights",
          .kind = ParameterKind::choice,
          .default_value = weight_kinds[0],
          .choices = weight_kinds,
          .description =
              "With sum: factor of the given weights. given: 1; agreement: estimated from the nearest models, by how "
              "many a signature shares with the other signatures, and how many neighbours share with each other."},
      Parameter{.name = "score",
                .kind = ParameterKind::choice,
                .default_value = rank_scores[0],
                .choices = rank_scores,
                .description = "With fuse_ranks: score of a rank. reciprocal: 1 / (60 + rank), which favours first "
                               "ranks; borda: linear in the rank."}};
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
      throw ConfigurationError{std::string(parameter.name), fmt::format("requires \"{}\"", belongs_to)};
    }
  }
  if (key == kinds_of_derived[0]) return sum_of(signature);
  return key == kinds_of_derived[1] ? rank_fusion_of(signature) : reranking_of(signature);
}

}  // namespace shapegauge
