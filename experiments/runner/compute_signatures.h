#pragma once

#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/datasets/dataset.h"
#include "shapegauge/experiments/datasets/dataset_layouts.h"
#include "shapegauge/experiments/fields/field.h"
#include "shapegauge/experiments/results/shape_report.h"
#include "shapegauge/experiments/runner/run_control.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// The signatures of the models of a data set.
struct ComputedSignatures {
  std::vector<std::size_t> models;     ///< those that have signatures, by index in the data set
  std::vector<Signatures> signatures;  ///< by signature of the configuration; row i is of models[i]
  std::vector<FieldReport> fields;
  std::vector<ShapeReport> shapes;     ///< of the models that have signatures
  std::vector<ModelFailure> failures;  ///< the other models, with OnError::skip
};

/// Computes all signatures of the configuration, in parallel over the models; the same bytes for any number of threads.
/// Every model's file is looked at first. With OnError::stop the first model that fails ends it with an InputError,
/// with OnError::skip the run goes on without it. Throws InputError, too, where no model is left, and Interrupted. Runs
/// in the calling TBB arena. What the cache holds is taken from it, and what is computed is kept there.
ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunControl& control, Cache& cache);

}  // namespace shapegauge
