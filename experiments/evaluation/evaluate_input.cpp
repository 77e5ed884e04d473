#include "shapegauge/experiments/evaluation/evaluate_input.h"

namespace shapegauge {
namespace {

CheckedEvaluation by_rows(const ComparedFeatures& compared, const EvaluationInput& input,
                          const EvaluationOptions& options) {
  MatrixChecks checks(input.same_rows_and_columns);
  const DistanceRows distances = [&](Eigen::Index first, Eigen::Index count) {
    DistanceMatrix rows = distance_rows(compared.features, first, count, compared.distance);
    checks.add(rows);
    return rows;
  };
  Evaluation evaluation = evaluate(distances, input.task, options);
  return {.evaluation = std::move(evaluation), .findings = checks.findings()};
}

}  // namespace

CheckedEvaluation evaluate_and_check(const EvaluationInput& input, const EvaluationOptions& options) {
  if (input.features) return by_rows(*input.features, input, options);
  CheckedEvaluation result{.evaluation = evaluate(input.distances, input.task, options), .findings = {}};
  if (!input.task.lists_may_end_early) {
    result.findings = check_matrix(input.distances, input.same_rows_and_columns);
  }
  return result;
}

}  // namespace shapegauge
