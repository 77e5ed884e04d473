#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/experiments/files/table.h"
#include "shapegauge/experiments/runner/run_comparison.h"

namespace shapegauge {

/// A row for each signature, shape and bin: the bin's number and bounds, and its share of the area.
Table histograms_table(const ComparisonResults& results);

/// A row for each signature and shape: its distance from the reference. Without a reference, no rows.
Table distances_table(const ComparisonResults& results);

/// A row for each signature and shape: samples, those without a value, and the ValueErrors, if there are any.
Table errors_table(const ComparisonResults& results);

/// A row for each signature whose field estimates normals, and shape: the NormalErrors of those and of its own.
Table normals_table(const ComparisonResults& results);

/// A row for each signature and shape: how long things took. The one table that differs from run to run.
Table timings_table(const ComparisonResults& results);

/// Writes all result files of a comparison into the folder, made where absent, each whole or not at all, the manifest
/// last; then removes what an earlier run wrote and this one has not. Throws InputError where a file cannot be written:
/// the folder then holds what it held before (StagedResults).
void write_comparison(const std::filesystem::path& destination, const ComparisonResults& results);

/// The results' summary for a terminal: distances, errors, normals, timings.
std::string summary_text(const ComparisonResults& results);

}  // namespace shapegauge
