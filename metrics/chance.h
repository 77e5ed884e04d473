// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Mean nearest-neighbour score (NN) of an evaluation, compared with that of a random order of the targets.
struct NearestNeighbourByChance {
  double found = 0;        ///< mean NN over all queries, from 0 to 1
  double expected = 0;     ///< expected mean NN of a random order of the targets
  double probability = 1;  ///< probability (upper bound) that a random order has a mean NN of at most `found`
};

/// Compares the mean NN of an evaluation of `task` with chance. Returns nothing if NN is not among the measures of the
/// evaluation.
std::optional<NearestNeighbourByChance> compare_nearest_with_chance(const Evaluation& evaluation,
                                                                    const RetrievalTask& task);

}  // namespace shapegauge
