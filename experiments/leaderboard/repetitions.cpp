// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/leaderboard/repetitions.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace shapegauge {

namespace {

// Positions of the submissions of each method, in their order.
std::vector<std::vector<std::size_t>> methods_of(const std::vector<EvaluatedSubmission>& submissions) {
  std::vector<std::vector<std::size_t>> methods;
  std::map<std::filesystem::path, std::size_t> known;
  for (std::size_t i = 0; i < submissions.size(); ++i) {
    const std::filesystem::path& method = submissions[i].submission.repetition_of;
    const std::size_t at = method.empty() ? methods.size() : known.emplace(method, methods.size()).first->second;
    if (at == methods.size()) methods.emplace_back();
    methods[at].push_back(i);
  }
  return methods;
}

void add_precisions(const PrecisionRecallCurve& curve, PrecisionRecallCurve& sum) {
  std::ranges::transform(curve.precision, sum.precision, sum.precision.begin(), std::plus());
}

void divide_precisions(PrecisionRecallCurve& curve, double count) {
  for (double& precision : curve.precision) precision /= count;
}

// Returns the mean scores; those of queries are `per_query`.
Evaluation mean_evaluation(const std::vector<const Evaluation*>& evaluations, Eigen::MatrixXd per_query) {
  Evaluation mean = *evaluations.front();
  for (std::size_t i = 1; i < evaluations.size(); ++i) {
    const Evaluation& one = *evaluations[i];
    mean.per_class += one.per_class;
    mean.micro += one.micro;
    mean.macro += one.macro;
    add_precisions(one.micro_curve, mean.micro_curve);
    add_precisions(one.macro_curve, mean.macro_curve);
    for (std::size_t c = 0; c < mean.class_curves.size(); ++c)
      add_precisions(one.class_curves[c], mean.class_curves[c]);
  }
  const auto count = static_cast<double>(evaluations.size());
  mean.per_query = std::move(per_query);
  mean.per_class /= count;
  mean.micro /= count;
  mean.macro /= count;
  divide_precisions(mean.micro_curve, count);
  divide_precisions(mean.macro_curve, count);
  for (PrecisionRecallCurve& curve : mean.class_curves) divide_precisions(curve, count);
  return mean;
}

// Returns the sample standard deviation of each measure's average.
Eigen::VectorXd deviation_of(const std::vector<const Evaluation*>& evaluations, Eigen::VectorXd Evaluation::*average) {
  Eigen::MatrixXd averages((evaluations[0]->*average).size(), std::ssize(evaluations));
  for (Eigen::Index i = 0; i < averages.cols(); ++i)
    averages.col(i) = evaluations[static_cast<std::size_t>(i)]->*average;
  averages.colwise() -= averages.rowwise().mean().eval();
  return (averages.rowwise().squaredNorm() / static_cast<double>(averages.cols() - 1)).cwiseSqrt();
}

// Combines repetitions with the mean `scores` of their queries.
EvaluatedSubmission combined(const std::vector<EvaluatedSubmission>& repetitions, const MethodScores& scores) {
  EvaluatedSubmission method = repetitions.front();
  std::vector<const Evaluation*> evaluations;
  for (const EvaluatedSubmission& one : repetitions) {
    evaluations.push_back(&one.evaluation);
    method.repetitions.push_back({.file = one.submission.file, .sha256 = one.sha256});
    for (const std::string& warning : one.warnings) {
      const bool known = std::ranges::find(method.warnings, warning) != method.warnings.end();
      if (!known) method.warnings.push_back(warning);
    }
  }
  method.evaluation = mean_evaluation(evaluations, scores.values);
  method.micro_deviation = deviation_of(evaluations, &Evaluation::micro);
  method.macro_deviation = deviation_of(evaluations, &Evaluation::macro);
  method.fit_for_report = false;
  return method;
}

// Returns the mean scores of repetitions, aligned to the queries of the first.
MethodScores mean_scores(const std::vector<MethodScores>& repetitions) {
  const AlignedMethods aligned = align_methods(repetitions, repetitions.front().measures);
  MethodScores mean = repetitions.front();
  for (std::size_t k = 0; k < aligned.values.size(); ++k) {
    mean.values.col(static_cast<Eigen::Index>(k)) = aligned.values[k].rowwise().mean();
  }
  return mean;
}

}  // namespace

void combine_repetitions(std::vector<EvaluatedSubmission>& submissions, std::vector<MethodScores>& scores) {
  std::vector<EvaluatedSubmission> methods;
  std::vector<MethodScores> scores_of_methods;
  for (const std::vector<std::size_t>& positions : methods_of(submissions)) {
    std::vector<EvaluatedSubmission> repetitions;
    std::vector<MethodScores> scores_of_repetitions;
    for (const std::size_t i : positions) {
      repetitions.push_back(std::move(submissions[i]));
      scores_of_repetitions.push_back(std::move(scores[i]));
    }
    const bool several = positions.size() > 1;
    scores_of_methods.push_back(several ? mean_scores(scores_of_repetitions) : std::move(scores_of_repetitions[0]));
    methods.push_back(several ? combined(repetitions, scores_of_methods.back()) : std::move(repetitions[0]));
  }
  submissions = std::move(methods);
  scores = std::move(scores_of_methods);
}

}  // namespace shapegauge
