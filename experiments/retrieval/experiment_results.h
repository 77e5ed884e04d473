// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"
#include "shapegauge/metrics/distance_overview.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Results of a run for one signature.
struct MethodResults {
  std::string name;
  DistanceMatrix distances;  ///< rows and columns are ExperimentResults::models; empty if not kept or written to a file
  DistanceOverview overview;            ///< for the report; empty if not requested
  std::vector<Evaluation> evaluations;  ///< by protocol of the configuration
  /// Models, by index in ExperimentResults::models, that the method cannot process, although others can, with
  /// OnError::skip: infinitely far from all others, so that they are never found and find nothing. Their signatures are
  /// NaN.
  std::vector<ModelFailure> failures = {};
  Signatures signatures;                   ///< row i is of ExperimentResults::models[i]; empty for derived distances
  std::vector<Interval> histogram_ranges;  ///< of each row, if the signature is one histogram; otherwise empty
  std::string remark = {};                 ///< remark_on() derived distances
};

/// Results of a run.
struct ExperimentResults : DescribedShapes {
  Configuration configuration;
  std::vector<std::string> classes;  ///< names, by label
  std::vector<Model> models;         ///< models with signatures
  std::vector<LeftOutShape> failures;
  SkippedEntries skipped;  ///< in the folder of the data set
  std::vector<MethodResults> methods;
  CacheReport cache;
  int threads = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage, in order
};

/// Returns a sentence for each method that cannot process all models: how many, which first and why.
std::vector<std::string> incomplete_methods(const ExperimentResults& results);

/// Returns warnings about the results of a run: field_warnings(), and for each method with tied queries (relevant and
/// other models at equal distance) their number and the range of FT over the orders of tied models; and its remark.
std::vector<std::string> run_warnings(const ExperimentResults& results);

}  // namespace shapegauge
