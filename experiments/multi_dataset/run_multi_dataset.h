// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge {

/// The kind "multi_dataset": one retrieval experiment on several data sets ("datasets" instead of "dataset"). Each
/// data set has the results of an experiment of its own in a folder of its name; those of the whole are tables of
/// methods by data sets, ranks and tests (compare_by_ranks()), and a page that leads to the reports. A data set that
/// cannot be used is left out, with the reason; the run fails where none can.
ExperimentKind multi_dataset_kind();

}  // namespace shapegauge
