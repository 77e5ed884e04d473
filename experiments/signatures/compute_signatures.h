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

/// Descriptions, pictures and interactive views of the models that have signatures, for reports.
struct DescribedShapes {
  std::vector<ModelDescription> shapes;  ///< per model: its description without_values()
  std::vector<std::string> pictures;     ///< per model: bytes of a PNG file; empty without pictures
  std::vector<std::string> views;        ///< per model: JSON of its view (model_view()); empty without views
  std::vector<ViewedField> viewed;       ///< fields in the views, each named after a signature that uses it
  std::vector<FieldReport> fields;       ///< per field of distinct_fields(): sample counts and run time over all models
};

/// Signatures of the models of a data set, with the failures and the statistics of the data set.
struct ComputedSignatures : DescribedShapes {
  std::vector<std::size_t> models;     ///< data-set indices of the models that have at least one signature
  std::vector<Signatures> signatures;  ///< per signature: table with one row per entry of `models`
  std::vector<ModelFailure> failures;  ///< models without any signature, by data-set index, with OnError::skip
  /// Per signature: the models that do not have it, although they have another; ModelFailure::model is an index into
  /// `models`.
  std::vector<std::vector<ModelFailure>> without;
  std::vector<LearntFeatures> learnt;  ///< per signature: features learnt from the data set; empty if it learns none
  std::vector<Interval> field_ranges;  ///< per field of distinct_fields(): interval of its values over all models
  std::vector<std::vector<Interval>>
      histogram_ranges;  ///< per signature: range of the histogram of each model; empty for one without field
};

/// Computes all signatures of the configuration, in parallel over the models. The result is the same, bit by bit, for
/// any number of threads. First checks every model's file. With OnError::stop the first failing model is an InputError.
/// With OnError::skip, models that cannot be used are omitted, and those without some of the signatures are named
/// (`without`). Throws InputError if no model is left in general or for one of the signatures, and Interrupted. Runs in
/// the calling TBB arena. Reads results from the cache and stores new ones there.
ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunContext& context);

/// Computes, for one part of a run (Part), the results per model that compute_signatures() needs, and stores them in
/// the cache. Throws InputError for a model of the part that fails with OnError::stop, and Interrupted.
PartOutcome describe_part(const Dataset& dataset, const Configuration& configuration, const RunContext& context,
                          const Part& part);

/// Returns true if the cache has the results per model that compute_signatures() needs, for every model that can be
/// used.
bool are_all_described(const Dataset& dataset, const Configuration& configuration, const RunContext& context);

}  // namespace shapegauge
