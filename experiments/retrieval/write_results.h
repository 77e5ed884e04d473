// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/retrieval/experiment_results.h"

namespace shapegauge {

/// Makes the experiment that runs a retrieval configuration. Distances are written by rows; whole matrices are in
/// memory only in the cases that run_methods() lists.
Experiment retrieval_experiment(Configuration configuration);

/// Returns the kind of experiment "retrieval", for experiment_kinds().
ExperimentKind retrieval_kind();

/// Writes all result files of a run (docs/reference/file_formats.md#results-of-a-run) except the manifest and the
/// distances, which run_experiment() writes by rows. Adds the entries of the experiment to the manifest. With `bold`,
/// the summary for a terminal has the best scores in bold. Throws InputError if a file cannot be written.
RunOutcome write_results(const RunResults& to, const ExperimentResults& results, bool bold = false);

/// Returns the names of the `.npy` files of distances, one per signature; empty if the configuration does not keep
/// distances.
std::vector<std::string> distance_files(const Configuration& configuration);

}  // namespace shapegauge
