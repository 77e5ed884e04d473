// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>
#include <vector>

#include "tests/metrics/naive_evaluation.h"

namespace shapegauge {

/// Distance matrix, classes of its models, and protocol.
struct EvaluationCase {
  naive::Matrix distances;
  std::vector<int> labels;
  Protocol protocol = Protocol::psb;
};

/// Random cases of 2 to so many models in classes of very unequal sizes, at least one of two models or more. Distances
/// are drawn from a few values, so that most are tied, infinity among them; symmetric or not; the diagonal too is
/// random.
rc::Gen<EvaluationCase> cases_with_ties(std::size_t max_models = 60);

/// Random cases of at most 60 models with distinct distances.
rc::Gen<EvaluationCase> cases_without_ties();

}  // namespace shapegauge
