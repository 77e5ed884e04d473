#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"

namespace shapegauge {

/// Formats diagnostics by the names of ShapeDiagnostics. `boundary_fraction`, `gap_fraction` and `noise_fraction` are
/// lengths divided by the diagonal, or 0 without one.
nlohmann::ordered_json diagnostics_json(const ShapeDiagnostics& diagnostics);

/// Adds columns to a table whose rows are shapes: the choices of perturbations, the diagnostics, and for each field the
/// number of samples by outcome.
TextTable with_shape_reports(TextTable table, std::span<const ShapeReport> shapes,
                             const PreparationOptions& preparation, std::span<const FieldReport> fields);

/// Makes a table with a row for each model: id, class, choices of perturbations, diagnostics, and for each field the
/// number of samples by outcome. The same for any number of threads.
TextTable shapes_table(std::span<const Model> models, std::span<const std::string> classes,
                       std::span<const ShapeReport> shapes, const PreparationOptions& preparation,
                       std::span<const FieldReport> fields);

/// Makes a table with a row for each model: id, and the seconds of each field and each descriptor.
TextTable shape_seconds_table(std::span<const Model> models, std::span<const ShapeReport> shapes,
                              std::span<const FieldReport> fields, std::span<const SignatureConfiguration> signatures);

/// Formats for each field its settings, its samples by outcome, and the number of shapes that its offset leaks into.
nlohmann::ordered_json fields_json(std::span<const FieldReport> fields);

/// Formats the run-dependent data: threads, seconds by stage, and seconds by field.
nlohmann::ordered_json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                                      std::span<const FieldReport> fields);

}  // namespace shapegauge
