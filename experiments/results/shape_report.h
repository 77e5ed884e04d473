#pragma once

#include <cstddef>
#include <vector>

#include "shapegauge/core/shape/diagnostics.h"
#include "shapegauge/experiments/fields/field.h"

namespace shapegauge {

/// What a run found of one model, as it was measured: after the perturbations, in the file's units.
struct ShapeReport {
  ShapeDiagnostics diagnostics;
  std::vector<std::size_t> chosen;      ///< what perturbations that choose have chosen, in order
  std::vector<FieldOutcomes> outcomes;  ///< by field
  std::vector<double> seconds;          ///< by field
};

}  // namespace shapegauge
