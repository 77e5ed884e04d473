#include "shapegauge/experiments/configuration/perturbation_steps.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/experiments/configuration/parameter_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 2> assignments{"random", "in_turn"};

constexpr std::array one_of_parameters{
    Parameter{.name = "assign",
              .kind = ParameterKind::choice,
              .default_value = assignments[0],
              .choices = assignments,
              .description = "random: drawn for each model; in_turn: by the model's place in the data set."}};

constexpr PerturbationType one_of_type{.name = "one_of",
                                       .description = "Gives each model one of the lists of steps in its `choices`.",
                                       .parameters = one_of_parameters,
                                       .has_choices = true};

Perturbation one_of(const Json& settings) {
  const ParameterValues values = read_parameters(one_of_parameters, settings);
  const bool in_turn = values.word("assign") == "in_turn";
  std::vector<std::vector<Perturbation>> choices;
  Perturbation step{.settings = to_json(values), .versions = {{one_of_type.name, 1}}, .apply = {}};
  step.settings["type"] = one_of_type.name;
  step.settings["choices"] = Json::array();
  for (const Json& choice : settings.at("choices")) {
    choices.push_back(make_perturbations(choice));
    step.settings["choices"].push_back(to_json(choices.back()));
    for (const Perturbation& chosen : choices.back()) step.versions.update(chosen.versions);
  }
  step.apply = [in_turn, choices = std::move(choices)](Shape shape, PerturbationContext& context) {
    const auto drawn = static_cast<std::size_t>(context.random.uniform(0, static_cast<double>(choices.size())));
    const std::size_t choice = in_turn ? context.model % choices.size() : std::min(drawn, choices.size() - 1);
    context.chosen->push_back(choice);
    return apply_perturbations(std::move(shape), choices[choice], context);
  };
  return step;
}

/// 64-bit FNV-1a hash, which is the same on every platform, unlike std::hash.
std::uint64_t stable_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

Shape apply_perturbations(Shape shape, const std::vector<Perturbation>& steps, PerturbationContext& parent) {
  for (const Perturbation& step : steps) {
    PerturbationContext own{.random = RandomNumbers(parent.random.next()),
                            .model = parent.model,
                            .chosen = parent.chosen,
                            .remarks = parent.remarks};
    shape = step.apply(std::move(shape), own);
  }
  return shape;
}

PerturbedShape perturb_model(Shape shape, const std::vector<Perturbation>& steps, std::uint64_t seed,
                             std::string_view id, std::size_t model) {
  PerturbedShape perturbed;
  PerturbationContext context{.random = RandomNumbers(seed, stable_hash(id)),
                              .model = model,
                              .chosen = &perturbed.chosen,
                              .remarks = &perturbed.remarks};
  perturbed.shape = apply_perturbations(std::move(shape), steps, context);
  return perturbed;
}

std::vector<PerturbationType> perturbation_types() {
  std::vector<PerturbationType> types;
  for (const ShapePerturbation& type : shape_perturbations().entries()) {
    types.push_back({.name = type.name, .description = type.description, .parameters = type.parameters});
  }
  types.push_back(one_of_type);
  return types;
}

Perturbation make_perturbation(const Json& settings) {
  const std::string name = settings.at("type");
  const ShapePerturbation* const type = shape_perturbations().find(name);
  if (type == nullptr && name != one_of_type.name) {
    std::vector<std::string> names;
    for (const PerturbationType& any : perturbation_types()) names.emplace_back(any.name);
    throw InputError(unknown_word_message("perturbation", name, names));
  }
  return type == nullptr ? one_of(settings) : make_perturbation(*type, read_parameters(type->parameters, settings));
}

Perturbation make_perturbation(const ShapePerturbation& type, const ParameterValues& values) {
  Perturbation step{.settings = to_json(values),
                    .versions = {{type.name, type.version}},
                    .apply = [type, values](Shape shape, PerturbationContext& context) {
                      Shape perturbed = type.apply(std::move(shape), values, context.random);
                      std::string remark = type.remark == nullptr ? "" : type.remark(perturbed, values);
                      if (!remark.empty() && context.remarks != nullptr) context.remarks->push_back(std::move(remark));
                      return perturbed;
                    }};
  step.settings["type"] = type.name;
  return step;
}

std::vector<Perturbation> make_perturbations(const Json& list) {
  std::vector<Perturbation> steps;
  for (const Json& settings : list) steps.push_back(make_perturbation(settings));
  return steps;
}

Json to_json(const std::vector<Perturbation>& steps) {
  Json list = Json::array();
  for (const Perturbation& step : steps) list.push_back(step.settings);
  return list;
}

}  // namespace shapegauge
