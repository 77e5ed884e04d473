#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/datasets/dataset.h"
#include "shapegauge/experiments/fields/field.h"
#include "shapegauge/experiments/results/shape_report.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// A model that a run went on without.
struct FailedModel {
  Model model;
  std::string message;
};

/// What a run found for one signature.
struct MethodResults {
  std::string name;
  DistanceMatrix distances;             ///< rows and columns are ExperimentResults::models
  std::vector<Evaluation> evaluations;  ///< by protocol of the configuration
};

/// All that a run found.
struct ExperimentResults {
  Configuration configuration;
  std::vector<std::string> classes;  ///< names, by label
  std::vector<Model> models;         ///< those that have signatures
  std::vector<ShapeReport> shapes;   ///< of the models
  std::vector<FailedModel> failures;
  std::vector<FieldReport> fields;
  std::vector<MethodResults> methods;
  CacheReport cache;
  int threads = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage, in order
};

}  // namespace shapegauge
