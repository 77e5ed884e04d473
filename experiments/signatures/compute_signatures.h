// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/experiments/signatures/shape_reports.h"
#include "shapegauge/pages/report.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Reports on the models with signatures, and their drawings.
struct DescribedShapes {
  std::vector<ModelDescription> shapes;  ///< per model, without_values()
  std::vector<std::string> pictures;     ///< per model, as PNG files; empty if not configured
  std::vector<std::string> views;        ///< per model, interactive 3D views (model_view()); empty if not configured
  std::vector<ViewedField> viewed;  ///< fields of the views, named after the first signature that is a histogram of it,
                                    ///< or the one that has it pictured
  std::vector<FieldReport> fields;
};

/// Signatures of the models of a data set.
struct ComputedSignatures : DescribedShapes {
  std::vector<std::size_t> models;     ///< models with signatures, by index in the data set
  std::vector<Signatures> signatures;  ///< of those models, as assemble_signatures() returns them
  std::vector<ModelFailure> failures;  ///< the other models, with OnError::skip: no signature can be computed
  /// By signature: those of `models`, by position, that do not have it, although they have another.
  std::vector<std::vector<ModelFailure>> without;
  std::vector<LearntFeatures> learnt;  ///< per signature; empty if it does not learn
  std::vector<Interval> field_ranges;  ///< per field, over all models
  std::vector<std::vector<Interval>>
      histogram_ranges;  ///< per signature: range of each model's histogram; empty without a field
};

/// Computes all signatures of the configuration, in parallel over the models. The same bytes for any number of threads.
/// First checks every model's file. With OnError::stop the first failing model is an InputError. With OnError::skip,
/// models that cannot be used are omitted, and those without some of the signatures are named (`without`). Throws
/// InputError if no model is left in general or for one of the signatures, and Interrupted. Runs in the calling TBB
/// arena. Reads results from the cache and stores new ones there.
ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunContext& context);

/// Computes, for one part of the models, the results per model that compute_signatures() needs, and stores them in the
/// cache. Throws InputError for a model of the part that fails with OnError::stop, and Interrupted.
PartOutcome describe_part(const Dataset& dataset, const Configuration& configuration, const RunContext& context,
                          const Part& part);

/// Returns true if the cache has what compute_signatures() needs of every model that can be used.
bool are_described(const Dataset& dataset, const Configuration& configuration, const RunContext& context);

}  // namespace shapegauge
