#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"
#include "shapegauge/metrics/distance_overview.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Model that a run omitted.
struct FailedModel {
  Model model;
  std::string message;
};

/// Results of a run for one signature.
struct MethodResults {
  std::string name;
  DistanceMatrix distances;  ///< rows and columns are ExperimentResults::models; empty if not kept or written to a file
  DistanceOverview overview;            ///< for the report; empty if not requested
  std::vector<Evaluation> evaluations;  ///< by protocol of the configuration
  /// Models, by index in ExperimentResults::models, that the method cannot take, although others can, with
  /// OnError::skip: infinitely far from all others, so that they are never found and find nothing. Their signatures are
  /// NaN.
  std::vector<ModelFailure> failures = {};
  Signatures signatures;  ///< row i is of ExperimentResults::models[i]; empty for derived distances and, with several
                          ///< processes, if needed by neither report nor files
  std::vector<Interval> histogram_ranges;  ///< of each row, if the signature is one histogram; otherwise empty
};

/// Results of a run.
struct ExperimentResults {
  Configuration configuration;
  std::vector<std::string> classes;   ///< names, by label
  std::vector<Model> models;          ///< models with signatures
  std::vector<ShapeReport> shapes;    ///< by model
  std::vector<std::string> pictures;  ///< by model, as PNG files; empty if not configured
  std::vector<std::string> views;     ///< by model, interactive 3D views (model_view()); empty if not configured
  std::vector<ViewedField> viewed;    ///< fields of the views
  std::vector<FailedModel> failures;
  SkippedEntries skipped;  ///< in the folder of the data set
  std::vector<FieldReport> fields;
  std::vector<MethodResults> methods;
  CacheReport cache;
  int threads = 1;  ///< of each process
  int processes = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage, in order
};

/// Computes distance_matrix() or reads it from the cache; stores it there. A matrix of more than 64 MB (2,900 shapes)
/// is not cached, because it is computed as fast as it is read. Throws as distance_matrix() does.
DistanceMatrix distances_through_cache(const Signatures& signatures, const std::string& distance, Cache& cache);

/// Computes descriptor_distances() through the cache in the same way.
DistanceMatrix distances_through_cache(const Signatures& features, const Descriptor& descriptor, Cache& cache);

/// Maximum number of models for whole distance matrices on rank 0 with several processes, as needed by sums, fusions
/// and re-ranking. 2 GiB each.
inline constexpr std::size_t most_models_of_derived_distances = 16384;

/// Destinations of a run.
struct RunPlaces {
  std::filesystem::path generated_folder;  ///< of a generated data set
  /// By signature: `.npy` file of its distances, written by rows. If empty, the results contain the distances that the
  /// configuration keeps.
  std::vector<std::filesystem::path> distance_files;
};

/// Runs a whole experiment: data set, signatures, distances, evaluation. Throws InputError for a model that fails with
/// OnError::stop and for data that cannot be evaluated; throws Interrupted. Results are the same bytes whatever the
/// state of the cache, for any number of threads and processes; rank 0 has them.
///
/// Distances are computed, evaluated and written by rows (judge_distances.h). Whole matrices are in memory in three
/// cases: for derived distances and those that they derive from; if the results contain them; and for up to 2,900
/// models, through the cache. With several processes, rank 0 holds those of the first case; more than
/// most_models_of_derived_distances models are an InputError. Collective.
ExperimentResults run_experiment(const Configuration& configuration, const RunPlaces& places, const RunControl& control,
                                 Cache& cache, Communicator& ranks);

/// Runs an experiment in this process alone, without a cache and with the matrices in the results.
ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control);

/// Returns a sentence for each method that cannot take all models: how many, which first and why.
std::vector<std::string> incomplete_methods(const ExperimentResults& results);

/// Returns warnings about the results of a run: field_warnings(), and for each method with tied queries (relevant and
/// other models at equal distance) their number and the range of FT over the orders of tied models.
std::vector<std::string> run_warnings(const ExperimentResults& results);

}  // namespace shapegauge
