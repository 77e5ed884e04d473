#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/experiments/fields/field_source.h"
#include "shapegauge/experiments/fields/sample_plan.h"

namespace shapegauge {

/// How many samples had which outcome, by the outcome's name. "total" is always there; "undecided" and "missing" are
/// the outcomes that a run warns about.
using FieldOutcomes = std::map<std::string, std::size_t>;

/// The values of a field on one shape.
struct FieldValues {
  Eigen::VectorXd values;  ///< one a sample; NaN where there is none
  Points normals = {};     ///< of fields that estimate them: outward unit normals, one a sample; else empty
  FieldOutcomes outcomes;
  std::optional<double> offset;  ///< r as a fraction of the diagonal, where the field chose it for the shape
  double build_seconds = 0;      ///< spatial structures, those shared with other fields of the shape included
  double query_seconds = 0;      ///< all samples
};

/// A scalar field that a configuration asks for: where its samples are and how its values are computed.
struct Field {
  nlohmann::json settings;  ///< type and all settings, defaults filled in; fields with equal settings are one field
  nlohmann::json versions;  ///< of the algorithms that the values depend on besides the samples, by name
  SamplePlan samples;
  /// The values at the samples of a shape; parallel: spread the samples over the threads of the calling TBB arena.
  std::function<FieldValues(FieldSource&, const Samples&, bool parallel)> compute;
};

/// What a run did with a field, over all models used.
struct FieldReport {
  nlohmann::json settings;
  FieldOutcomes outcomes;  ///< sums
  double seconds = 0;      ///< sum over the models, whatever ran at the same time
};

}  // namespace shapegauge
