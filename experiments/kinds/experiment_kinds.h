#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shapegauge/core/base/registry.h"
#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge {

/// All kinds of experiments: those of the library, then those that were added. An entry has both functions.
Registry<ExperimentKind>& experiment_kinds();

/// The experiment that the document of a configuration describes. Of several kinds that know it the last one that was
/// added has it, and one that no kind knows is read as the first kind, which says what is missing. Throws as
/// ExperimentKind::read.
Experiment read_experiment(const nlohmann::json& document, const std::string& source,
                           const std::filesystem::path& folder);

}  // namespace shapegauge
