#pragma once

#include <span>

#include "shapegauge/experiments/results/experiment_results.h"
#include "shapegauge/experiments/text/table.h"

namespace shapegauge {

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
