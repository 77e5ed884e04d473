// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/shape_comparison/measure_shape.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

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
  std::vector<MeasuredShape> shapes;  ///< usable shapes, without_values()
  std::vector<LeftOutShape> failures;
  std::vector<FieldReport> fields;
  std::vector<SignatureResults> signatures;  ///< per signature of the comparison
  CacheReport cache;
  int threads = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage, in order
};

/// Runs a whole comparison: fields, histograms, distances from the reference, errors; shapes are measured through the
/// cache. Shapes are measured one after the other with all threads, which makes their timings comparable; the reference
/// comes first. Everything but the timings is the same for any number of threads. Writes nothing. Throws InputError for
/// a shape that fails with OnError::stop, a reference that fails, and if no shape is left; throws Interrupted.
ShapeComparisonResults run_shape_comparison(const ShapeComparison& comparison, const RunContext& context);

/// Measures a part of the shapes and stores the measurements in the cache. Throws as run_shape_comparison() does.
PartOutcome run_part_of_comparison(const ShapeComparison& comparison, const RunContext& context, const Part& part);

}  // namespace shapegauge
