// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/method_comparison.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/equal_scores.h"

namespace shapegauge {

namespace {

void check(const Eigen::MatrixXd& per_query, const UnitValues& units, const ComparisonOptions& options) {
  if (per_query.cols() < 2)
    throw ArgumentError("a comparison needs at least two methods, not " + std::to_string(per_query.cols()));
  if (!per_query.allFinite()) throw ArgumentError("scores to compare must be finite numbers");
  if (units.values.rows() < 2) {
    throw ArgumentError("a comparison over " + name_of(options.blocks) + " needs at least two " +
                        name_of(options.blocks) + ", not " + std::to_string(units.values.rows()));
  }
  if (options.reference && *options.reference >= static_cast<std::size_t>(per_query.cols())) {
    throw ArgumentError("the reference has index " + std::to_string(*options.reference) + ", but there are " +
                        std::to_string(per_query.cols()) + " methods, counted from 0");
  }
}

std::vector<std::pair<std::size_t, std::size_t>> pairs_of(std::size_t methods, std::optional<std::size_t> reference) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t first = 0; first < methods; ++first) {
    if (reference) {
      if (first != *reference) pairs.emplace_back(*reference, first);
      continue;
    }
    for (std::size_t second = first + 1; second < methods; ++second) pairs.emplace_back(first, second);
  }
  return pairs;
}

double bootstrap_p_value(const Eigen::VectorXd& resampled, double observed) {
  const double distance = std::abs(observed) * (1 - score_rounding);
  const Eigen::Index as_far = ((resampled.array() - observed).abs() >= distance).count();
  return (1.0 + static_cast<double>(as_far)) / (1.0 + static_cast<double>(resampled.size()));
}

double p_value(const Eigen::VectorXd& differences, const UnitValues& units, const Eigen::VectorXd& resampled,
               double observed, const ComparisonOptions& options) {
  switch (options.test) {
    case PairTest::t:
      return paired_t_p_value(contributions(differences, units.weights));
    case PairTest::bootstrap:
      return bootstrap_p_value(resampled, observed);
    case PairTest::randomisation:
      break;
  }
  return randomisation_p_value(differences, units.weights, options.resampling);
}

/// Applies Holm's correction to the p-values of all pairs.
void adjust(std::vector<PairDifference>& pairs, double PairDifference::*p, double PairDifference::*adjusted) {
  std::vector<double> values;
  for (const PairDifference& pair : pairs) values.push_back(pair.*p);
  const std::vector<double> corrected = adjust_by_holm(values);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].*adjusted = corrected[i];
}

}  // namespace

double min_attainable_p_value(const ComparisonOptions& options, Eigen::Index units) {
  const double of_resamples = 1.0 / (1.0 + options.resampling.resamples);
  switch (options.test) {
    case PairTest::t:
      return 0;
    case PairTest::bootstrap:
      return of_resamples;
    case PairTest::randomisation:
      break;
  }
  return min_attainable_tukey_p_value(2, units, options.resampling);
}

double class_p_value(const Eigen::VectorXd& differences, std::span<const int> classes) {
  const auto class_means = [&](const Eigen::VectorXd& values) -> Eigen::ArrayXd {
    return unit_values_of(values, classes, ResamplingUnit::classes, Average::macro).values;
  };
  // Differences that cancel leave the rounding of their sums, relative to their magnitudes.
  if (std::abs(differences.sum()) <= score_rounding * differences.cwiseAbs().sum()) return 1;
  Eigen::ArrayXd means = class_means(differences);
  means = (means.abs() <= score_rounding * class_means(differences.cwiseAbs())).select(0.0, means).eval();
  if (means.size() < 2 || means.mean() * differences.mean() <= 0) return 1;
  const bool equal = (means - means[0]).abs().maxCoeff() <= score_rounding * std::abs(means[0]);
  return equal ? std::pow(2.0, 1.0 - static_cast<double>(means.size())) : paired_t_p_value(means);
}

double min_class_effect(std::size_t classes, std::size_t pairs, double alpha) {
  if (classes < 2) return std::numeric_limits<double>::infinity();
  const auto count = static_cast<double>(classes);
  const boost::math::students_t student(count - 1);
  const double tail = alpha / static_cast<double>(2 * pairs);
  return boost::math::quantile(boost::math::complement(student, tail)) / std::sqrt(count);
}

MethodComparison compare_methods(const Eigen::MatrixXd& per_query, std::span<const int> classes,
                                 const ComparisonOptions& options) {
  const UnitValues units = unit_values_of(per_query, classes, options.blocks, options.average);
  check_options("comparison", comparison_table, options);
  check(per_query, units, options);
  const Eigen::MatrixXd resampled = bootstrap_averages(units, options.resampling);
  const Eigen::MatrixXd tukey = tukey_hsd_p_values(units, options.resampling);
  MethodComparison comparison;
  comparison.units = units.values.rows();
  comparison.classes = std::ssize(std::set(classes.begin(), classes.end()));
  comparison.averages = averages_of(units);
  comparison.intervals = percentile_intervals(resampled, comparison.units, options.confidence);
  for (const auto& [first, second] : pairs_of(static_cast<std::size_t>(per_query.cols()), options.reference)) {
    const auto a = static_cast<Eigen::Index>(first);
    const auto b = static_cast<Eigen::Index>(second);
    const Eigen::VectorXd differences = score_differences(units.values.col(a), units.values.col(b));
    const Eigen::VectorXd query_differences = score_differences(per_query.col(a), per_query.col(b));
    const Eigen::VectorXd resampled_differences = resampled.col(a) - resampled.col(b);
    PairDifference pair{.first = first,
                        .second = second,
                        .difference = are_equal_scores(comparison.averages[a], comparison.averages[b])
                                          ? 0
                                          : differences.dot(units.weights)};
    pair.interval = percentile_intervals(resampled_differences, comparison.units, options.confidence).front();
    pair.p = p_value(differences, units, resampled_differences, pair.difference, options);
    pair.p_tukey = tukey(a, b);
    pair.effect_size = effect_size(contributions(differences, units.weights));
    pair.queries = win_tie_loss(query_differences);
    pair.p_classes = class_p_value(query_differences, classes);
    comparison.pairs.push_back(pair);
  }
  adjust(comparison.pairs, &PairDifference::p, &PairDifference::p_holm);
  adjust(comparison.pairs, &PairDifference::p_classes, &PairDifference::p_classes);
  return comparison;
}

}  // namespace shapegauge
