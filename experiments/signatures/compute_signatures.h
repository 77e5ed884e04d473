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

/// Report on one model, after the perturbations, in the file's units.
struct ShapeReport {
  std::string sha256 = {};  ///< of the file; empty without a file
  ShapeDiagnostics diagnostics;
  std::vector<std::size_t> chosen;             ///< choices of perturbations that choose, in order
  double area = 0;                             ///< area that was scaled to 1, in the file's units squared
  double noise = 0;                            ///< NoiseLevel::relative(), if the preparation estimates noise
  double pass_band = 0;                        ///< of the preparation's smoothing; 0 if not smoothed
  std::vector<FieldOutcomes> outcomes;         ///< by field
  std::vector<std::optional<double>> offsets;  ///< by field: the offset, if it chose one
  std::vector<double> seconds;                 ///< by field
  std::vector<double> descriptor_seconds;      ///< by signature that is a descriptor, without its fields
};

/// Returns the distance between signatures of a kind that is not derived: a descriptor's own, or the configuration's.
NamedDistance distance_between(const SignatureConfiguration& signature, const Configuration& configuration);

/// Returns the range of each field of the plan over the models that have values of it. Throws ArgumentError if none
/// has.
std::vector<Interval> field_ranges(const std::vector<const ModelDescription*>& models, std::size_t fields);

/// Assembles the signatures, in the configuration's order, of all models: row i is of models[i], NaN for a model
/// without the signature. A signature that no model has is without columns. Signatures derived from distances are
/// empty. `data_set_ranges` are the ranges of the plan's fields over the whole data set, if a histogram needs them.
/// Runs in the calling TBB arena. Throws ArgumentError if a descriptor returns features of different lengths.
std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const PlannedField> plan,
                                            const std::vector<SignatureConfiguration>& signatures,
                                            std::span<const Interval> data_set_ranges);

/// Checks whether the model's gaps are wider than the offset of a field: the one that the field chose or, without one,
/// that of its settings. Fields without an offset do not leak.
bool leaks(const ShapeDiagnostics& model, std::optional<double> chosen_offset, const nlohmann::json& settings);

/// Report on a field over all models used.
struct FieldReport {
  nlohmann::json settings;  ///< as in a configuration
  FieldOutcomes outcomes;   ///< totals
  double seconds = 0;       ///< total over the models, including concurrent work
  std::size_t models = 0;   ///< with values of it
  std::size_t leaking = 0;  ///< models with gaps wider than the field's offset (gap_size()), into which it leaks
};

/// Returns the reports on the plan's fields over all models.
std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const PlannedField> plan);

/// Returns the report on a model.
ShapeReport report_shape(const ModelDescription& model);

/// Returns the range of each model's histogram of a field.
std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& wanted, std::size_t field);

/// Signatures of the models of a data set. With several processes, each has those of consecutive models; all reports on
/// models are on rank 0.
struct ComputedSignatures {
  std::vector<std::size_t> models;     ///< models with signatures, by index in the data set
  RankRange own;                       ///< positions in `models` of those whose rows are here
  std::vector<Signatures> signatures;  ///< of those models, as assemble_signatures() returns them
  std::vector<ModelFailure> failures;  ///< the other models, with OnError::skip: no signature can be computed
  /// By signature: those of `models`, by position, that do not have it, although they have another.
  std::vector<std::vector<ModelFailure>> without;
  std::vector<LearntFeatures> learnt;  ///< by planned descriptor; empty if it does not learn
  std::vector<Interval> field_ranges;  ///< by field of the plan, over all models
  std::vector<std::vector<Interval>>
      histogram_ranges;               ///< by signature: range of each model's histogram; empty without a field
  std::vector<std::string> pictures;  ///< by model; empty if not configured
  std::vector<std::string> views;     ///< by model, interactive 3D views; empty if not configured
  std::vector<ViewedField> viewed;  ///< fields of the views, named after the first signature that is a histogram of it,
                                    ///< or the one that has it pictured
  std::vector<FieldReport> fields;
  std::vector<ShapeReport> shapes;  ///< by model with signatures
};

/// Computes all signatures of the configuration, in parallel over the models, which are shared by the processes. The
/// same bytes for any number of threads and processes. First checks every model's file. With OnError::stop the first
/// failing model is an InputError. With OnError::skip, models that cannot be used are omitted, and those without some
/// of the signatures are named (`without`). Throws InputError if no model is left in general or for one of the
/// signatures, and Interrupted. Collective. Runs in the calling TBB arena. Reads results from the cache and stores new
/// ones there.
ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunControl& control, Cache& cache, Communicator& ranks);

/// Returns warnings about the fields, one sentence each: offsets that leak, samples undecided or without a value.
std::vector<std::string> field_warnings(std::span<const FieldReport> fields);

}  // namespace shapegauge
