#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

namespace shapegauge {

/// The kind of processor and those of its instruction sets by which the libraries choose their code at run time, such
/// as "x86-64 sse4.2 avx2 fma avx512f": with others the last bits of values may differ.
std::string processor();

/// The program and what it runs on: version, commit, compiler, build type, libraries, processor.
nlohmann::ordered_json program_json();

/// SHA-256 of the result files in the folder, by name; not of tables of timings, which differ from run to run.
nlohmann::ordered_json outputs_json(const std::filesystem::path& folder, std::span<const std::string> files);

}  // namespace shapegauge
