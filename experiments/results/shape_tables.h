#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/runner/run_experiment.h"

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
Table shapes_table(const ExperimentResults& results);

/// A row for each model: id, and the seconds that each field took.
Table shape_seconds_table(const ExperimentResults& results);

}  // namespace shapegauge
