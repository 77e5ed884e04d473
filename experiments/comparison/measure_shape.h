#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/experiments/comparison/comparison.h"
#include "shapegauge/experiments/comparison/comparison_results.h"
#include "shapegauge/experiments/runner/describe_model.h"
#include "shapegauge/experiments/runner/field_plan.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

/// What the shapes of a comparison are compared with.
struct ReferenceShape {
  double diagonal = 0;
  std::optional<TrueNormals> normals;  ///< where it is a mesh
  std::vector<PlacedValues> values;    ///< by field
};

/// A shape of a comparison with all that the histograms need.
struct MeasuredShape {
  ShapeMeasurement measurement;
  ModelDescription description;
};

/// Reads, perturbs and prepares the shape of this index, and computes the planned fields on it.
/// - `reference`: what to compare with; nullptr: nothing. Measuring the reference itself fills it.
/// Throws what describe_shape throws, and Interrupted between fields.
MeasuredShape measure_shape(const Comparison& comparison, std::size_t index, std::span<const PlannedField> plan,
                            ReferenceShape* reference, const RunControl& control);

}  // namespace shapegauge
