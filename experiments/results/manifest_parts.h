#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/experiments/fields/field.h"

/// The parts that the manifests of all kinds of runs have.
namespace shapegauge {

/// The program and what it runs on: version, commit, compiler, build type, libraries, processor.
nlohmann::ordered_json program_json();

/// SHA-256 of the result files in the folder, by name; not of tables of timings, which differ from run to run.
nlohmann::ordered_json outputs_json(const std::filesystem::path& folder, std::span<const std::string> files);

/// For each field its settings and its samples by outcome.
nlohmann::ordered_json fields_json(std::span<const FieldReport> fields);

/// Threads, seconds by stage, and seconds by field: what differs from run to run.
nlohmann::ordered_json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                                      std::span<const FieldReport> fields);

}  // namespace shapegauge
