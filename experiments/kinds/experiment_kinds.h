#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shapegauge/core/base/registry.h"
#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge {

/// Returns the registry of kinds of experiments: those of the library, followed by those added. An entry must have both
/// functions.
Registry<ExperimentKind>& experiment_kinds();

/// Reads the experiment of a configuration's document. If several kinds recognise it, the last one added is used; if
/// none does, the first kind reads it and reports what is missing. Throws as ExperimentKind::read does.
Experiment read_experiment(const nlohmann::json& document, const std::string& source,
                           const std::filesystem::path& folder);

}  // namespace shapegauge
