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

/// Results of a retrieval experiment for one method, which is a signature with its distances.
struct MethodResults {
  std::string name;
  DistanceMatrix distances;   ///< between all ExperimentResults::models; empty if not kept or written to a file
  DistanceOverview overview;  ///< heat map and nearest neighbours for the report; empty if not requested
  std::vector<Evaluation> evaluations;  ///< scores, one evaluation per protocol of the configuration
  /// Models, as indices into ExperimentResults::models, that the method cannot process although other methods can
  /// (OnError::skip). They are infinitely far from all other models, and their signatures are NaN.
  std::vector<ModelFailure> failures = {};
  Signatures signatures;  ///< row i is the signature of ExperimentResults::models[i]; empty for derived distances
  std::vector<Interval> histogram_ranges;  ///< range of each model's histogram; empty for other signatures
  std::string remark = {};                 ///< warning of remark_on() about derived distances; may be empty
};

/// Results of a retrieval experiment: models, distances and scores of all methods, failures.
struct ExperimentResults : DescribedShapes {
  Configuration configuration;
  std::vector<std::string> classes;  ///< names of the classes; Model::label is an index
  std::vector<Model> models;         ///< models with a signature by at least one method
  std::vector<LeftOutShape> failures;
  SkippedEntries skipped;  ///< entries in the folder of the data set that are not its models
  std::vector<MethodResults> methods;
  CacheReport cache;
  int threads = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< name and run time in seconds of each stage, in order
};

/// Returns a sentence for each method that cannot process all models: their number, and the first of them with the
/// reasons.
std::vector<std::string> incomplete_methods(const ExperimentResults& results);

/// Returns warnings about the results of a run, one sentence each: field_warnings(), clouds with outliers or wrong
/// normals, remarks on derived distances. Also, for each method, the number of queries with relevant and other models
/// at equal distance and the range of the first tier (FT) over the orders of ties.
std::vector<std::string> run_warnings(const ExperimentResults& results);

}  // namespace shapegauge
