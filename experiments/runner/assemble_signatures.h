#pragma once

#include <span>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/results/shape_report.h"
#include "shapegauge/experiments/runner/describe_model.h"
#include "shapegauge/experiments/runner/field_plan.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// The signatures, in the configuration's order, of all models: row i is of models[i]. Runs in the calling TBB arena.
std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const PlannedField> plan,
                                            const std::vector<SignatureConfiguration>& signatures);

/// What the plan's fields did, over all models.
std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const PlannedField> plan);

/// What is reported of a model.
ShapeReport report_shape(const ModelDescription& model);

/// The range of each model's histogram of a field.
std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& wanted, std::size_t field);

}  // namespace shapegauge
