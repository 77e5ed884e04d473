#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/experiments/runner/compute_signatures.h"
#include "shapegauge/experiments/runner/run_experiment.h"

namespace shapegauge {

/// What the manifest of a retrieval experiment says besides the program, the configuration and the files: seed, SHA-256
/// of every input, models, failures, outcomes of samples.
nlohmann::ordered_json manifest_entries(const ExperimentResults& results);

/// Its "execution": threads, processes, timings, and how many results of each kind came from the cache.
nlohmann::ordered_json execution_entries(const ExperimentResults& results);

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
