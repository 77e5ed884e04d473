#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// What a perturbation may depend on besides the shape.
struct PerturbationContext {
  RandomNumbers random;                        ///< a stream of the step's own
  std::size_t model = 0;                       ///< the model's index in the data set
  std::vector<std::size_t>* chosen = nullptr;  ///< where steps that choose append what they chose
};

/// A step that a configuration asks for: how shapes are changed before anything is computed of them.
struct Perturbation {
  nlohmann::json settings;  ///< type and all settings, defaults filled in
  nlohmann::json versions;  ///< of the step's type, and of the types of the steps that it may choose
  std::function<Shape(Shape, PerturbationContext&)> apply;
};

/// Applies the steps one after the other. Each has a stream of its own, which the parent's next number seeds: what one
/// step draws does not change what the others do.
Shape apply_perturbations(Shape shape, const std::vector<Perturbation>& steps, PerturbationContext& parent);

/// A model's shape after the steps.
struct PerturbedShape {
  Shape shape;
  std::vector<std::size_t> chosen;  ///< by step that chooses, in order of application: the index of its choice
};

/// Applies the steps to a model. What is drawn depends on the seed and the model's id only, not on the other models.
PerturbedShape perturb_model(Shape shape, const std::vector<Perturbation>& steps, std::uint64_t seed,
                             std::string_view id, std::size_t model);

/// A type of perturbation that configurations can name.
struct PerturbationType {
  std::string_view name;         ///< the value of "type"
  std::string_view description;  ///< one sentence
  std::span<const Parameter> parameters;
  bool has_choices = false;  ///< has the setting "choices", too: lists of steps
};

/// All types of perturbations: those of shape_perturbations(), to which shape_perturbations().add() adds, and
/// "one_of", which gives each model one of several lists of steps.
std::vector<PerturbationType> perturbation_types();

/// The step that the settings describe, by their "type". Throws InputError for a type that is not in
/// perturbation_types(), and for settings that the type does not take.
Perturbation make_perturbation(const nlohmann::json& settings);

/// The steps of a list.
std::vector<Perturbation> make_perturbations(const nlohmann::json& list);

/// The settings of the steps, defaults filled in, in the form that make_perturbations() takes.
nlohmann::json to_json(const std::vector<Perturbation>& steps);

}  // namespace shapegauge
