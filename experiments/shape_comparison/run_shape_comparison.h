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

/// Results of a shape comparison for one signature: histograms of all shapes and distances from the reference.
struct SignatureResults {
  std::size_t field = 0;          ///< index in MeasuredShape::fields of the field of the signature
  Signatures histograms;          ///< row i is the histogram of ShapeComparisonResults::shapes[i]
  std::vector<Interval> ranges;   ///< range of the field values that each shape's histogram covers
  std::vector<double> distances;  ///< distance of each shape from the reference; empty without a reference
};

/// Results of a shape comparison: measurements of all shapes, histograms, distances and failures.
struct ShapeComparisonResults {
  ShapeComparison comparison;                           ///< comparison with its settings
  std::vector<MeasuredShape> shapes;                    ///< usable shapes with their measurements, but no field values
  std::vector<LeftOutShape> failures;                   ///< shapes that could not be measured, with the reasons
  std::vector<FieldReport> fields;                      ///< per field: numbers of samples and run times over all shapes
  std::vector<SignatureResults> signatures;             ///< results per signature of the comparison
  CacheReport cache;                                    ///< numbers of results found in the cache and computed
  int threads = 1;                                      ///< number of threads of the run
  std::vector<std::pair<std::string, double>> timings;  ///< steps of the run with their times in seconds, in order
};

/// Runs a whole shape comparison: computes fields, histograms, distances from the reference and errors; shapes are
/// measured through the cache. Shapes are measured one after the other with all threads, which makes their timings
/// comparable; the reference comes first. Everything but the timings is the same for any number of threads. Writes
/// nothing. Throws InputError for a shape that fails with OnError::stop, a reference that fails, and if no shape is
/// left; throws Interrupted.
ShapeComparisonResults run_shape_comparison(const ShapeComparison& comparison, const RunContext& context);

/// Measures one part (engine/part.h) of the shapes, for runs on several machines, and stores the measurements in the
/// cache. Throws as run_shape_comparison() does.
PartOutcome run_part_of_comparison(const ShapeComparison& comparison, const RunContext& context, const Part& part);

}  // namespace shapegauge
