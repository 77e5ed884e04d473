#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/experiments/comparison/field_errors.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// What a comparison found of one field on one shape.
struct FieldMeasurement {
  std::size_t samples = 0;
  std::size_t missing = 0;  ///< samples without a value
  double build_seconds = 0;
  double query_seconds = 0;
  std::optional<ValueErrors> errors;           ///< with a reference that the shapes are registered with
  std::optional<NormalErrors> offset_normals;  ///< so too, if the field estimates normals and the reference is a mesh
  std::optional<NormalErrors> own_normals;     ///< of the samples; along with offset_normals
};

/// What a comparison found of one shape.
struct ShapeMeasurement {
  std::string name;
  ShapeReport report;
  double read_seconds = 0;               ///< reading or generating it
  std::vector<FieldMeasurement> fields;  ///< by field
};

/// What a comparison found for one signature.
struct SignatureResults {
  std::size_t field = 0;          ///< index of the field that it is a histogram of
  Signatures histograms;          ///< row i is of shape i
  std::vector<Interval> ranges;   ///< of the shapes' histograms
  std::vector<double> distances;  ///< of the shapes from the reference; empty without one
};

/// All that a comparison found.
struct ShapeComparisonResults {
  ShapeComparison comparison;
  std::vector<ShapeMeasurement> shapes;  ///< those that could be used
  std::vector<LeftOutShape> failures;
  std::vector<FieldReport> fields;
  std::vector<SignatureResults> signatures;  ///< by signature of the comparison
  int threads = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage, in order
};

/// Runs a whole comparison: fields, histograms, distances from the reference, errors. The shapes are measured one after
/// the other, each with all threads, so that their timings can be compared; all but the timings is the same for any
/// number of threads. Writes nothing. Throws InputError for a shape that fails with OnError::stop, for a reference that
/// fails, where no shape is left, and Interrupted.
ShapeComparisonResults run_shape_comparison(const ShapeComparison& comparison, const RunControl& control);

}  // namespace shapegauge
