// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge {

/// Returns the kind "multi_dataset" for experiment_kinds(): one retrieval experiment on several data sets
/// ("datasets" instead of "dataset"). Each data set has the results of a separate experiment, in a folder of its name.
/// The results over all data sets are tables of methods by data sets, ranks and tests (compare_by_ranks()), and a page
/// with links to the reports. A data set that cannot be used is left out, with the reason; the run fails if no data set
/// can be used.
ExperimentKind multi_dataset_kind();

}  // namespace shapegauge
