#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// The name of the file in the folder that is written last and lists the others.
inline constexpr std::string_view manifest_name = "manifest.json";

/// Whether the result file of that name holds seconds, which differ from run to run.
bool holds_timings(std::string_view file);

/// Whether a file that a run of any kind writes is in the folder.
bool has_results(const std::filesystem::path& folder);

/// Makes the folder, where absent. Throws InputError where that is not possible.
void make_folder(const std::filesystem::path& folder);

/// The results that the manifest of an earlier run in the folder lists: names that runs give to files and no others.
std::vector<std::string> earlier_results(const std::filesystem::path& folder);

/// Removes those of the earlier files that have not been written anew.
void remove_superseded(const std::filesystem::path& folder, std::span<const std::string> earlier,
                       std::span<const std::string> written);

/// Makes the folder for a run's results ready, before the run. A folder that is new, has no results in it, or has those
/// of the very same configuration may be used: repeating a run replaces its files. Throws InputError where the folder
/// holds the results of something else, unless `replace` is set, or cannot be made or written to.
void prepare_result_folder(const std::filesystem::path& folder, const nlohmann::json& configuration, bool replace);

}  // namespace shapegauge
