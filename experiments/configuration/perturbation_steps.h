#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// State of a perturbation step besides the shape.
struct PerturbationContext {
  RandomNumbers random;                         ///< random stream of the step
  std::size_t model = 0;                        ///< the model's index in the data set
  std::vector<std::size_t>* chosen = nullptr;   ///< receives the choices of steps that choose
  std::vector<std::string>* remarks = nullptr;  ///< receives ShapePerturbation::remark() of the steps; may be null
};

/// Perturbation step of a configuration, applied to shapes before anything is computed.
// NOLINTNEXTLINE(bugprone-exception-escape): JSON moves without exceptions, which the check does not see
struct Perturbation {
  nlohmann::json settings;  ///< type and all settings, with all defaults
  nlohmann::json versions;  ///< versions of the step's type, and of the types that it may choose
  std::function<Shape(Shape, PerturbationContext&)> apply;
};

/// Applies the steps in order. Each has its own random stream, seeded by the parent's next number: the draws of one
/// step do not affect the others.
Shape apply_perturbations(Shape shape, const std::vector<Perturbation>& steps, PerturbationContext& parent);

/// Shape of a model after the perturbation steps.
struct PerturbedShape {
  Shape shape;
  std::vector<std::size_t> chosen;        ///< by step that chooses, in order of application: index of the choice
  std::vector<std::string> remarks = {};  ///< how the steps fell short of their settings
};

/// Applies the steps to a model. Random draws depend only on the seed and the model's id, not on other models.
PerturbedShape perturb_model(Shape shape, const std::vector<Perturbation>& steps, std::uint64_t seed,
                             std::string_view id, std::size_t model);

/// Type of perturbation step in configurations.
struct PerturbationType {
  std::string_view name;         ///< value of "type"
  std::string_view description;  ///< one sentence
  std::span<const Parameter> parameters;
  bool has_choices = false;  ///< also has the setting "choices": lists of steps
};

/// Returns all types of perturbations: the entries of shape_perturbations(), and "one_of", which applies one of several
/// lists of steps to each model.
std::vector<PerturbationType> perturbation_types();

/// Makes the step with the given settings, by their "type". Throws InputError for a type that is not in
/// perturbation_types(), and for invalid settings.
Perturbation make_perturbation(const nlohmann::json& settings);

/// Makes the step of a registered type with the given values of its parameters.
Perturbation make_perturbation(const ShapePerturbation& type, const ParameterValues& values);

/// Makes the steps of a list.
std::vector<Perturbation> make_perturbations(const nlohmann::json& list);

/// Formats the settings of the steps as make_perturbations() takes them, with all defaults.
nlohmann::json to_json(const std::vector<Perturbation>& steps);

}  // namespace shapegauge
