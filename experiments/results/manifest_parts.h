#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/experiments/fields/field.h"

/// The parts that the manifests of all kinds of runs have.
namespace shapegauge {

/// The program: version, commit, compiler, build type, libraries.
nlohmann::ordered_json program_json();

/// For each field its settings and its samples by outcome.
nlohmann::ordered_json fields_json(std::span<const FieldReport> fields);

/// Threads, seconds by stage, and seconds by field: what differs from run to run.
nlohmann::ordered_json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                                      std::span<const FieldReport> fields);

}  // namespace shapegauge
