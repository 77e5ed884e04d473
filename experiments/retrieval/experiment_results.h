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
  std::string name;                     ///< name of the signature
  DistanceMatrix distances;             ///< distances between all models; empty if written to a file or not requested
  DistanceOverview overview;            ///< heat map and nearest neighbours, for the report; empty without a report
  std::vector<Evaluation> evaluations;  ///< scores, one evaluation per protocol of the configuration
  /// Models, as indices into ExperimentResults::models, that the method cannot process although other methods can
  /// (OnError::skip). They are infinitely far from all other models, and their signatures are NaN.
  std::vector<ModelFailure> failures = {};
  Signatures signatures;  ///< row i is the signature of ExperimentResults::models[i]; empty for derived distances
  std::vector<Interval> histogram_ranges;  ///< range of each model's histogram; empty for other signatures
  std::string remark = {};                 ///< warning of remark_on() about derived distances; empty if none
};

/// Results of a retrieval experiment: models, distances and scores of all methods, failures.
struct ExperimentResults : DescribedShapes {
  Configuration configuration;         ///< configuration of the experiment
  std::vector<std::string> classes;    ///< names of the classes; Model::label is an index into them
  std::vector<Model> models;           ///< models with a signature by at least one method
  std::vector<LeftOutShape> failures;  ///< models without any signature, with the reasons
  SkippedEntries skipped;              ///< numbers of files and folders of the data set that are not models
  std::vector<MethodResults> methods;  ///< results of each signature, in the order of the configuration
  CacheReport cache;                   ///< numbers of results found in the cache and computed
  int threads = 1;                     ///< number of threads of the run
  std::vector<std::pair<std::string, double>> timings;  ///< steps of the run with their times in seconds, in order
};

/// Returns a sentence for each method that cannot process all models: their number, and the first of them with the
/// reasons.
std::vector<std::string> incomplete_methods(const ExperimentResults& results);

/// Returns warnings about the results of a run, one sentence each: field_warnings(), clouds with outliers or wrong
/// normals, remarks on derived distances. Also, for each method, the number of queries with relevant and irrelevant
/// models at equal distance, and the range of the first tier (FT) over the orders of ties.
std::vector<std::string> run_warnings(const ExperimentResults& results);

}  // namespace shapegauge
