// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/retrieval/experiment_results.h"

namespace shapegauge {

/// Makes a retrieval experiment. Distances are written by rows; whole matrices are in memory only as run_experiment()
/// documents.
Experiment retrieval_experiment(Configuration configuration);

/// Returns the entry for experiment_kinds().
ExperimentKind retrieval_kind();

/// Writes all result files of a run (docs/reference/file_formats.md#results-of-a-run) but the manifest and the
/// distances, which run_experiment() writes by rows, and sets the manifest's entries. The summary has the best scores
/// in bold if `bold`. Throws InputError if a file cannot be written.
RunOutcome write_results(const RunResults& to, const ExperimentResults& results, bool bold = false);

/// Returns the names of the files of distances, by signature; empty if the configuration does not keep them.
std::vector<std::string> distance_files(const Configuration& configuration);

}  // namespace shapegauge
