// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Nearest neighbours of all queries, compared with those of a random order of the targets.
struct NearestByChance {
  double found = 0;        ///< mean NN
  double expected = 0;     ///< mean NN of a random order
  double probability = 1;  ///< that a random order has as few relevant nearest neighbours, or fewer; an upper bound
};

/// Compares the nearest neighbours of an evaluation with chance. Nothing if NN is not among its measures.
std::optional<NearestByChance> nearest_by_chance(const Evaluation& evaluation, const RetrievalTask& task);

}  // namespace shapegauge
