#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"

namespace shapegauge {

/// The diagnostics by name, as ShapeDiagnostics has them; `boundary_fraction`, `gap_fraction` and
/// `noise_fraction` are lengths over the diagonal, or 0 where there is none.
nlohmann::ordered_json diagnostics_json(const ShapeDiagnostics& diagnostics);

/// The table, whose rows name the shapes, with more columns: the choices of a shape's perturbations, its diagnostics,
/// and for each field the number of samples of each outcome.
Table with_shape_reports(Table table, std::span<const ShapeReport> shapes, const PreparationOptions& preparation,
                         std::span<const FieldReport> fields);

/// A row for each model: id, class, the choices of its perturbations, its diagnostics, and for each field the number of
/// samples of each outcome. The same whatever the number of threads.
Table shapes_table(std::span<const Model> models, std::span<const std::string> classes,
                   std::span<const ShapeReport> shapes, const PreparationOptions& preparation,
                   std::span<const FieldReport> fields);

/// A row for each model: id, and the seconds that each field and each descriptor took.
Table shape_seconds_table(std::span<const Model> models, std::span<const ShapeReport> shapes,
                          std::span<const FieldReport> fields, std::span<const SignatureConfiguration> signatures);

/// For each field its settings, its samples by outcome, and how many shapes its offset leaks into.
nlohmann::ordered_json fields_json(std::span<const FieldReport> fields);

/// Threads, seconds by stage, and seconds by field: what differs from run to run.
nlohmann::ordered_json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                                      std::span<const FieldReport> fields);

}  // namespace shapegauge
