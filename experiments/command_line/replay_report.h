#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace shapegauge {

/// Warns on standard error of inputs of a run that are not those recorded, at most ten by name.
void warn_of_changed_inputs(const std::vector<std::string>& changes);

/// Says on standard output, once a recorded run was repeated, for each of its outputs whether it is the same bytes, and
/// what else is not as recorded: inputs, program. Returns the exit status: 1 where an output differs.
int report_replay(const nlohmann::json& recorded, const std::filesystem::path& results);

}  // namespace shapegauge
