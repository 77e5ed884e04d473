#pragma once

#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluation_input.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/matrix_checks.h"

namespace shapegauge {

/// What was found in a matrix, a sentence each, with what it does to the figures. ids are those of the rows. `negated`:
/// the matrix was one of similarities, and they were negated, so that negative entries mean nothing.
std::vector<std::string> matrix_warnings(const MatrixFindings& findings, std::span<const std::string> ids,
                                         bool negated);

/// What distances are worth, and what is odd about them.
struct CheckedEvaluation {
  Evaluation evaluation;
  MatrixFindings findings;  ///< none of ranked lists, of which there is no matrix to doubt
};

/// Evaluates an input and looks at its distances. Those between features are computed a few hundred rows at a time and
/// forgotten: the same, bit by bit, as of their whole matrix, in memory that grows with the number of models and not
/// with its square. Throws std::invalid_argument as evaluate() does.
CheckedEvaluation evaluate_and_check(const EvaluationInput& input, const EvaluationOptions& options);

}  // namespace shapegauge
