#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

namespace shapegauge {

/// The program and what it runs on: version, commit, compiler, build type, libraries, processor.
nlohmann::ordered_json program_json();

/// SHA-256 of the result files in the folder, by name; not of tables of timings, which differ from run to run.
nlohmann::ordered_json outputs_json(const std::filesystem::path& folder, std::span<const std::string> files);

}  // namespace shapegauge
