#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace shapegauge {

/// Makes the folder for a run's results ready, before the run. A folder that is new, has no results in it, or has those
/// of the very same configuration may be used: repeating a run replaces its files. Throws InputError where the folder
/// holds the results of something else, unless forced, or cannot be made or written to.
void prepare_result_folder(const std::filesystem::path& folder, const nlohmann::json& configuration, bool force);

}  // namespace shapegauge
