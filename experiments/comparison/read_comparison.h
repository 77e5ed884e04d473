#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/experiments/comparison/comparison.h"

namespace shapegauge {

/// Reads a comparison from the document of a configuration, with the checks of configuration_from_json. `source` is
/// what messages call it; relative paths are relative to `folder`. Throws InputError with the source, the path to the
/// value, what is wrong and the nearest valid word.
Comparison comparison_from_json(const nlohmann::json& document, const std::string& source,
                                const std::filesystem::path& folder);

}  // namespace shapegauge
