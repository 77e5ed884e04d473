#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/experiments/comparison/comparison_results.h"

namespace shapegauge {

/// Writes all result files of a comparison into the folder, made where absent, each whole or not at all, the manifest
/// last; then removes what an earlier run wrote and this one has not. Throws InputError where a file cannot be written:
/// the folder then holds what it held before (StagedResults).
void write_comparison(const std::filesystem::path& destination, const ComparisonResults& results);

/// The results' summary for a terminal: distances, errors, normals, timings.
std::string summary_text(const ComparisonResults& results);

}  // namespace shapegauge
