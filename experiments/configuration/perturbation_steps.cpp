// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/perturbation_steps.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/experiments/configuration/parameter_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 2> assignments{"random", "in_turn"};

constexpr std::array one_of_parameters{Parameter{
    .name = "assign",
    .kind = ParameterKind::choice,
    .default_value = assignments[0],
    .choices = assignments,
    .description =
        "Choice of the list of steps for each model. random: at random; in_turn: the lists in cyclic order."}};

constexpr PerturbationType one_of_type{.name = "one_of",
                                       .description = "Apply to each model one of the lists of steps in `choices`.",
                                       .parameters = one_of_parameters,
                                       .has_choices = true};

std::string_view name_of(const Perturbation& step) { return step.type == nullptr ? one_of_type.name : step.type->name; }

/// State of the steps of a model besides the shape.
struct PerturbationContext {
  RandomNumbers random;    ///< random stream of the steps
  std::size_t model;       ///< the model's index in the data set
  PerturbedShape* result;  ///< receives the choices and remarks
};

Shape apply_steps(Shape shape, const std::vector<Perturbation>& steps, PerturbationContext& context);

Shape apply_one_of(Shape shape, const Perturbation& step, PerturbationContext& context) {
  const std::size_t count = step.choices.size();
  const auto drawn = static_cast<std::size_t>(context.random.uniform(0, static_cast<double>(count)));
  const bool in_turn = step.values.word("assign") == "in_turn";
  const std::size_t choice = in_turn ? context.model % count : std::min(drawn, count - 1);
  context.result->chosen.push_back(choice);
  return apply_steps(std::move(shape), step.choices[choice], context);
}

Shape apply_step(Shape shape, const Perturbation& step, PerturbationContext& context) {
  if (step.type == nullptr) return apply_one_of(std::move(shape), step, context);
  shape = step.type->apply(std::move(shape), step.values, context.random);
  std::string remark = step.type->remark == nullptr ? "" : step.type->remark(shape, step.values);
  if (!remark.empty()) context.result->remarks.push_back(std::move(remark));
  return shape;
}

Shape apply_steps(Shape shape, const std::vector<Perturbation>& steps, PerturbationContext& context) {
  for (const Perturbation& step : steps) {
    PerturbationContext step_context{
        .random = RandomNumbers(context.random.next()), .model = context.model, .result = context.result};
    shape = apply_step(std::move(shape), step, step_context);
  }
  return shape;
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

PerturbedShape perturb_model(Shape shape, const std::vector<Perturbation>& steps, std::uint64_t seed,
                             std::string_view id, std::size_t model) {
  PerturbedShape perturbed;
  PerturbationContext context{.random = RandomNumbers(seed, stable_hash(id)), .model = model, .result = &perturbed};
  perturbed.shape = apply_steps(std::move(shape), steps, context);
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

std::vector<Perturbation> make_perturbations(const Json& list) {
  std::vector<Perturbation> steps;
  for (const Json& settings : list) {
    const std::string name = settings.at("type");
    const ShapePerturbation* const type = name == one_of_type.name ? nullptr : &shape_perturbations().at(name);
    const std::span<const Parameter> parameters = type == nullptr ? one_of_type.parameters : type->parameters;
    Perturbation& step =
        steps.emplace_back(Perturbation{.type = type, .values = read_parameters(parameters, settings)});
    if (type != nullptr) continue;
    for (const Json& choice : settings.at("choices")) step.choices.push_back(make_perturbations(choice));
  }
  return steps;
}

Json to_json(const std::vector<Perturbation>& steps) {
  Json list = Json::array();
  for (const Perturbation& step : steps) {
    Json& settings = list.emplace_back(to_json(step.values));
    settings["type"] = name_of(step);
    if (step.type != nullptr) continue;
    settings["choices"] = Json::array();
    for (const std::vector<Perturbation>& choice : step.choices) settings["choices"].push_back(to_json(choice));
  }
  return list;
}

std::map<std::string, int> versions_of(const std::vector<Perturbation>& steps) {
  std::map<std::string, int> versions;
  for (const Perturbation& step : steps) {
    versions.emplace(name_of(step), step.type == nullptr ? 1 : step.type->version);
    for (const std::vector<Perturbation>& choice : step.choices) versions.merge(versions_of(choice));
  }
  return versions;
}

}  // namespace shapegauge
