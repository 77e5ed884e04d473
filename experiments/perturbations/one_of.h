#pragma once

#include <nlohmann/json.hpp>

#include "shapegauge/experiments/perturbations/perturbation.h"

namespace shapegauge {

/// The perturbation type "one_of": applies one of the lists of steps in `choices`: with `assign` "random" one drawn at
/// random for each model, with "in_turn" that of the model's index in the data set modulo their number.
Perturbation one_of_step(const nlohmann::json& settings);

}  // namespace shapegauge
