#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/retrieval/experiment_results.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"

namespace shapegauge {

/// Maximum number of models for whole distance matrices on rank 0 with several processes, as needed by sums, fusions
/// and re-ranking. 2 GiB each.
inline constexpr std::size_t most_models_of_derived_distances = 16384;

/// Computes and evaluates the distances of all methods of a run; adds the methods and, on rank 0, their results. Moves
/// the signatures from `computed` to the results. `distance_files` is as for run_experiment().
///
/// Distances are computed, evaluated and written by rows (judge_distances.h). Whole matrices are in memory in three
/// cases: for derived distances and those that they derive from; if the results contain them; and for up to
/// most_models_of_cached_distances models. With several processes, rank 0 holds those of the first case; more than
/// most_models_of_derived_distances models are an InputError. Throws Interrupted. Collective.
void run_methods(const Configuration& configuration, const std::vector<std::filesystem::path>& distance_files,
                 const RunContext& context, ComputedSignatures& computed, ExperimentResults& results);

}  // namespace shapegauge
