// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Perturbation step of a configuration, applied to shapes before anything is computed.
struct Perturbation {
  const ShapePerturbation* type = nullptr;  ///< type of step, one of shape_perturbations(); null for "one_of"
  ParameterValues values;                   ///< values of the parameters of `type`; empty for "one_of"
  std::vector<std::vector<Perturbation>> choices = {};  ///< lists of steps of "one_of", one of which is applied
};

/// Shape of a model after the perturbation steps, with the choices made and warnings.
struct PerturbedShape {
  Shape shape;                            ///< perturbed shape
  std::vector<std::size_t> chosen;        ///< per "one_of" step, in order: index of the list of steps that was applied
  std::vector<std::string> remarks = {};  ///< warnings, one per step that achieved less than its settings request
};

/// Applies perturbation steps to the shape of a model, in order; `model` is its index in the data set. Random draws
/// depend only on the seed and the model's id, not on other models. Each step has its own random stream: the draws of
/// one step do not affect the others.
PerturbedShape perturb_model(Shape shape, const std::vector<Perturbation>& steps, std::uint64_t seed,
                             std::string_view id, std::size_t model);

/// Describes a type of perturbation step in configurations: its name and parameters.
struct PerturbationType {
  std::string_view name;                  ///< value of "type" in the settings of a step
  std::string_view description;           ///< description in one sentence
  std::span<const Parameter> parameters;  ///< parameters of the step
  bool has_choices = false;               ///< true for "one_of", whose setting "choices" has lists of steps
};

/// Returns all types of perturbations: the entries of shape_perturbations(), and "one_of", which applies one of several
/// lists of steps to each model.
std::vector<PerturbationType> perturbation_types();

/// Reads a list of perturbation steps from its settings. Throws InputError for a "type" that is not in
/// perturbation_types(), and for invalid settings.
std::vector<Perturbation> make_perturbations(const nlohmann::json& list);

/// Formats the settings of perturbation steps as make_perturbations() reads them, with all defaults.
nlohmann::json to_json(const std::vector<Perturbation>& steps);

/// Returns the cache version of each type of perturbation in `steps`, by name, including the lists of "one_of".
std::map<std::string, int> versions_of(const std::vector<Perturbation>& steps);

}  // namespace shapegauge
