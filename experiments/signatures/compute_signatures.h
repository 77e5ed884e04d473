#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/pages/report.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// What a run found of one model, after the perturbations, in the file's units.
struct ShapeReport {
  std::string sha256 = {};  ///< of the file; empty where there is none
  ShapeDiagnostics diagnostics;
  std::vector<std::size_t> chosen;             ///< what perturbations that choose have chosen, in order
  double area = 0;                             ///< that was scaled to 1, in the file's units, squared
  double noise = 0;                            ///< NoiseLevel::relative(), where the preparation looks for noise
  double pass_band = 0;                        ///< of the preparation's smoothing; 0: none
  std::vector<FieldOutcomes> outcomes;         ///< by field
  std::vector<std::optional<double>> offsets;  ///< by field, where it chose one
  std::vector<double> seconds;                 ///< by field
  std::vector<double> descriptor_seconds;      ///< by signature that is a descriptor, without its fields
};

/// The distance between signatures of that kind, which are not derived ones: a descriptor's own, or the
/// configuration's.
NamedDistance distance_between(const SignatureConfiguration& signature, const Configuration& configuration);

/// By field of the plan its range over these models, of which there is one at least.
std::vector<Interval> field_ranges(const std::vector<const ModelDescription*>& models, std::size_t fields);

/// The signatures, in the configuration's order, of all models: row i is of models[i]. Those that are derived from
/// distances are empty. `data_set_ranges`: by field of the plan that over the whole data set, where a histogram asks
/// for it. Runs in the calling TBB arena. Throws ArgumentError where a descriptor gives features of different
/// lengths.
std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const PlannedField> plan,
                                            const std::vector<SignatureConfiguration>& signatures,
                                            std::span<const Interval> data_set_ranges);

/// What a run did with a field, over all models used.
struct FieldReport {
  nlohmann::json settings;  ///< as of a configuration
  FieldOutcomes outcomes;   ///< sums
  double seconds = 0;       ///< sum over the models, whatever ran at the same time
  std::size_t models = 0;
  std::size_t leaking = 0;  ///< models with gaps wider than the field's offset (gap_size()): it leaks into them
};

/// What the plan's fields did, over all models.
std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const PlannedField> plan);

/// The report of a model.
ShapeReport report_shape(const ModelDescription& model);

/// The range of each model's histogram of a field.
std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& wanted, std::size_t field);

/// The signatures of the models of a data set. Each of several processes has those of some models, which follow each
/// other; all that is told of the models is on rank 0.
struct ComputedSignatures {
  std::vector<std::size_t> models;                      ///< those that have signatures, by index in the data set
  Range own;                                            ///< the places in `models` of those whose rows are here
  std::vector<Signatures> signatures;                   ///< of those, as assemble_signatures() gives them
  std::vector<ModelFailure> failures;                   ///< the other models, with OnError::skip
  std::vector<LearntFeatures> learnt;                   ///< by planned descriptor; empty where it does not learn
  std::vector<Interval> field_ranges;                   ///< by field of the plan, over all models
  std::vector<std::vector<Interval>> histogram_ranges;  ///< by signature, of each model; empty where it has no field
  std::vector<std::string> pictures;  ///< of the models, where the configuration wants them; else none
  std::vector<std::string> views;     ///< the same, for shapes that one can turn
  std::vector<ViewedField> viewed;    ///< the fields of the views, named after the first signature that is a histogram
                                      ///< of it, or the one that has it pictured
  std::vector<FieldReport> fields;
  std::vector<ShapeReport> shapes;  ///< of the models that have signatures
};

/// Computes all signatures of the configuration, in parallel over the models, which several processes share; the same
/// bytes for any number of threads and processes. Every model's file is looked at first. With OnError::stop the first
/// model that fails ends it with an InputError, with OnError::skip the run goes on without it. Throws InputError, too,
/// where no model is left, and Interrupted. Collective. Runs in the calling TBB arena. What the cache holds is taken
/// from it, and what is computed is kept there.
ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunControl& control, Cache& cache, Communicator& ranks);

/// What a reader of the results should know of the fields, a sentence each: offsets that leak, samples undecided or
/// without a value.
std::vector<std::string> field_warnings(std::span<const FieldReport> fields);

}  // namespace shapegauge
