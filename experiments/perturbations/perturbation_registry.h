#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/perturbations/perturbation.h"

namespace shapegauge {

/// A kind of perturbation that configurations can name.
struct PerturbationType {
  std::string_view name;
  /// The step of the given settings, which the schema has accepted.
  Perturbation (*make)(const nlohmann::json& settings);
};

/// All kinds of perturbations. A new one is a function in core/perturbation, one line in perturbation_registry.cpp, and
/// the description of its settings in configs/experiment.schema.json.
std::span<const PerturbationType> perturbation_types();

/// The step that the settings describe, by their "type". Throws InputError for a type that is not in
/// perturbation_types().
Perturbation make_perturbation(const nlohmann::json& settings);

/// The steps of a list.
std::vector<Perturbation> make_perturbations(const nlohmann::json& list);

/// The settings of the steps, defaults filled in, in the form that make_perturbations takes.
nlohmann::json to_json(const std::vector<Perturbation>& steps);

}  // namespace shapegauge
