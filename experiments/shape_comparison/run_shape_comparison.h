#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/shape_comparison/field_errors.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Results of a comparison for one field on one shape.
struct FieldMeasurement {
  std::size_t samples = 0;
  std::size_t missing = 0;  ///< samples without a value
  double build_seconds = 0;
  double query_seconds = 0;
  std::optional<ValueErrors> errors;           ///< only with a reference to which the shapes are registered
  std::optional<NormalErrors> offset_normals;  ///< likewise, if the field estimates normals and the reference is a mesh
  std::optional<NormalErrors> own_normals;     ///< of the samples' own normals; together with offset_normals
};

/// Results of a comparison for one shape.
struct ShapeMeasurement {
  std::string name;
  ShapeReport report;
  double read_seconds = 0;               ///< reading or generating the shape
  std::vector<FieldMeasurement> fields;  ///< by field
};

/// Results of a comparison for one signature.
struct SignatureResults {
  std::size_t field = 0;          ///< index of the signature's field
  Signatures histograms;          ///< row i is the histogram of shape i
  std::vector<Interval> ranges;   ///< ranges of the shapes' histograms
  std::vector<double> distances;  ///< distances of the shapes from the reference; empty without one
};

/// Results of a comparison.
struct ShapeComparisonResults {
  ShapeComparison comparison;
  std::vector<ShapeMeasurement> shapes;  ///< usable shapes
  std::vector<LeftOutShape> failures;
  std::vector<FieldReport> fields;
  std::vector<SignatureResults> signatures;  ///< by signature of the comparison
  int threads = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage, in order
};

/// Runs a whole comparison: fields, histograms, distances from the reference, errors. Shapes are measured one after the
/// other with all threads, which makes their timings comparable. Everything but the timings is the same for any number
/// of threads. Writes nothing. Throws InputError for a shape that fails with OnError::stop, a reference that fails, and
/// if no shape is left; throws Interrupted.
ShapeComparisonResults run_shape_comparison(const ShapeComparison& comparison, const RunControl& control);

}  // namespace shapegauge
