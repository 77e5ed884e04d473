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
  const ShapePerturbation* type = nullptr;              ///< an entry of shape_perturbations(); null for "one_of"
  ParameterValues values;                               ///< of the type's parameters
  std::vector<std::vector<Perturbation>> choices = {};  ///< of "one_of": lists of steps
};

/// Shape of a model after the perturbation steps.
struct PerturbedShape {
  Shape shape;
  std::vector<std::size_t> chosen;        ///< by step that chooses, in order of application: index of the choice
  std::vector<std::string> remarks = {};  ///< how the steps fell short of their settings
};

/// Applies the steps to a model in order. Random draws depend only on the seed and the model's id, not on other models.
/// Each step has its own random stream: the draws of one step do not affect the others.
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

/// Reads a list of steps. Throws InputError for a "type" that is not in perturbation_types(), and for invalid settings.
std::vector<Perturbation> make_perturbations(const nlohmann::json& list);

/// Formats the settings of the steps as make_perturbations() takes them, with all defaults.
nlohmann::json to_json(const std::vector<Perturbation>& steps);

/// Returns the cache versions of the steps' types, and of those of the steps that they may choose.
std::map<std::string, int> versions_of(const std::vector<Perturbation>& steps);

}  // namespace shapegauge
