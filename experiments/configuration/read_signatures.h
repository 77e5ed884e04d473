#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"

namespace shapegauge {

/// The signatures of a configuration's "signatures", which the schema has accepted. Throws MisplacedValue for two of
/// the same name, `concatenate` that points nowhere or to itself, and settings that contradict each other.
std::vector<SignatureConfiguration> read_signatures(const nlohmann::json& settings);

}  // namespace shapegauge
