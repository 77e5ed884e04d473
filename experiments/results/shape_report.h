#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/core/shape/diagnostics.h"
#include "shapegauge/experiments/fields/field.h"

namespace shapegauge {

/// What a run found of one model, as it was measured: after the perturbations, in the file's units.
struct ShapeReport {
  std::string sha256 = {};  ///< of the file; empty where there is none
  ShapeDiagnostics diagnostics;
  std::vector<std::size_t> chosen;             ///< what perturbations that choose have chosen, in order
  double area = 0;                             ///< that was scaled to 1, in the file's units, squared
  double noise = 0;                            ///< NoiseLevel::relative(), where the preparation looks for noise
  double pass_band = 0;                        ///< of the preparation's smoothing; 0: none
  std::vector<FieldOutcomes> outcomes;         ///< by field
  std::vector<std::optional<double>> offsets;  ///< by field, where it chose one
  std::vector<double> seconds;                 ///< by field
};

}  // namespace shapegauge
