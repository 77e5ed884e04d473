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

/// A model that a run went on without.
struct FailedModel {
  Model model;
  std::string message;
};

/// What a run found for one signature.
struct MethodResults {
  std::string name;
  DistanceMatrix distances;             ///< rows and columns are ExperimentResults::models; empty where nobody keeps
                                        ///< them, or a file does
  DistanceOverview overview;            ///< of the distances, for the report; empty where none is wanted
  std::vector<Evaluation> evaluations;  ///< by protocol of the configuration
  Signatures signatures;                ///< row i is of ExperimentResults::models[i]; empty for derived distances, and
                                        ///< of several processes where neither report nor files have them
  std::vector<Interval> histogram_ranges;  ///< of each row, where the signature is one histogram; else empty
};

/// All that a run found.
struct ExperimentResults {
  Configuration configuration;
  std::vector<std::string> classes;   ///< names, by label
  std::vector<Model> models;          ///< those that have signatures
  std::vector<ShapeReport> shapes;    ///< of the models
  std::vector<std::string> pictures;  ///< of the models, as PNG files; none at all where the configuration wants none
  std::vector<std::string> views;     ///< the same, for shapes that one can turn (model_view())
  std::vector<ViewedField> viewed;    ///< the fields of the views
  std::vector<FailedModel> failures;
  SkippedEntries skipped;  ///< in the folder of the data set
  std::vector<FieldReport> fields;
  std::vector<MethodResults> methods;
  CacheReport cache;
  int threads = 1;  ///< of each process
  int processes = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage, in order
};

/// distance_matrix(), taken from the cache where it is there, and else kept there. A matrix of more than 64 MB (2,900
/// shapes) is not kept: it is computed as fast as it is read. Throws as distance_matrix() does.
DistanceMatrix distances_through_cache(const Signatures& signatures, const std::string& distance, Cache& cache);

/// descriptor_distances(), in the same way.
DistanceMatrix distances_through_cache(const Signatures& features, const Descriptor& descriptor, Cache& cache);

/// The most models of which several processes, too, hold whole distance matrices, on rank 0: those that sums, fusions
/// and re-ranking are made of. 2 GiB each.
inline constexpr std::size_t most_models_of_derived_distances = 16384;

/// Where a run goes, and who runs it.
struct RunPlaces {
  std::filesystem::path generated_folder;  ///< of a data set that the configuration asks to generate
  /// By signature the `.npy` file of its distances, written by rows; none: those that the configuration keeps are in
  /// the results.
  std::vector<std::filesystem::path> distance_files;
};

/// Runs a whole experiment: data set, signatures, distances, evaluation. Throws InputError for a model that fails with
/// OnError::stop, for data that cannot be evaluated, and Interrupted. Results are the same bytes whatever the cache
/// holds, for any number of threads, and of processes, of which rank 0 has them.
///
/// Distances are computed, judged and written by rows (judge_distances.h). Whole matrices are in memory where they are
/// derived from others, or others from them; where the results have them; and up to 2,900 models, by way of the cache.
/// Of several processes rank 0 has those of the first kind; of more than most_models_of_derived_distances models it
/// does not, which is an InputError. Collective.
ExperimentResults run_experiment(const Configuration& configuration, const RunPlaces& places, const RunControl& control,
                                 Cache& cache, Communicator& ranks);

/// The same in this process alone, with the matrices in the results.
ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control, Cache& cache);

/// The same without a cache.
ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control);

/// Warnings about the results of a run: field_warnings(), and for each method with tied queries (relevant and other
/// models at equal distance) their number and the range of FT over the orders of tied models.
std::vector<std::string> run_warnings(const ExperimentResults& results);

}  // namespace shapegauge
