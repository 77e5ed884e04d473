// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/retrieval/experiment_results.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"

namespace shapegauge {

/// Throws ArgumentError if none of the models is a query, such as for a minimum class size that no class reaches.
void check_queries(const std::vector<Model>& models, const EvaluationOptions& options);

/// Computes and evaluates the distances of all methods of a run, and adds them to results.methods. Moves the signatures
/// from `computed` to the results. `distance_files` has a `.npy` path for each signature; if empty,
/// distances are not written.
///
/// Distances are streamed: computed, evaluated and written by rows (judge_distances.h), with the scores of rows in the
/// cache. Whole matrices are in memory in three cases: for derived distances and the distances that they derive from;
/// if the results contain the matrices; and for up to max_models_of_cached_distances models. Throws Interrupted.
void run_methods(const Configuration& configuration, const std::vector<std::filesystem::path>& distance_files,
                 const RunContext& context, ComputedSignatures& computed, ExperimentResults& results);

/// Returns true if a run on that many models streams the distances of at least one method, instead of having the whole
/// matrix in memory.
bool has_streamed_methods(const Configuration& configuration, std::size_t models);

/// Evaluates one part (engine/part.h) of the rows of all streamed distance matrices and stores the scores in the cache.
/// Returns the number of evaluated rows. `models` are the models with signatures. Throws Interrupted.
std::size_t evaluate_part_of_rows(const Configuration& configuration, const RunContext& context,
                                  const std::vector<Model>& models, const ComputedSignatures& computed,
                                  const Part& part);

}  // namespace shapegauge
