#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/experiments/configuration/fields.h"
#include "shapegauge/experiments/runner/run_experiment.h"

namespace shapegauge {

/// The manifest of a run: all there is to know of it and to repeat it. Program (program_json()), configuration with all
/// defaults filled in, SHA-256 of every input, outcomes of samples, failed models, and the files of its results, which
/// are in the folder already, with their SHA-256. Nothing in it but "execution" (threads, timings, use of the cache)
/// depends on the number of threads or on the cache.
nlohmann::ordered_json manifest(const ExperimentResults& results, const std::vector<std::string>& files,
                                const std::filesystem::path& folder);

/// The inputs of a run of a data set on disk as its manifest would record them. Models whose file cannot be read are
/// left out. Runs in the calling TBB arena.
nlohmann::ordered_json dataset_inputs(const Configuration& configuration, const std::vector<Model>& models);

// The parts that manifests of all kinds of runs have.

/// The program and what it runs on: version, commit, compiler, build type, libraries, processor.
nlohmann::ordered_json program_json();

/// SHA-256 of the result files in the folder, by name; not of tables of timings, which differ from run to run.
nlohmann::ordered_json outputs_json(const std::filesystem::path& folder, std::span<const std::string> files);

/// For each field its settings, its samples by outcome, and how many shapes its offset leaks into.
nlohmann::ordered_json fields_json(std::span<const FieldReport> fields);

/// Threads, seconds by stage, and seconds by field: what differs from run to run.
nlohmann::ordered_json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                                      std::span<const FieldReport> fields);

}  // namespace shapegauge
