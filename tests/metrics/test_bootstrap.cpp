// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/bootstrap.h"
#include "tests/metrics/simulated_methods.h"

namespace shapegauge {

namespace {

// Class 7: values 1, 2, 3; class 4: value 10.
const Eigen::MatrixXd values = (Eigen::MatrixXd(4, 1) << 1, 10, 2, 3).finished();
const std::vector<int> classes = {7, 4, 7, 7};

TEST(ResamplingUnits, AverageIsTheSameWhetherQueriesOrClassesAreResampled) {
  for (const ResamplingUnit unit : {ResamplingUnit::classes, ResamplingUnit::queries}) {
    EXPECT_DOUBLE_EQ(averages_of(unit_values_of(values, classes, unit, Average::micro))[0], 4);
    EXPECT_DOUBLE_EQ(averages_of(unit_values_of(values, classes, unit, Average::macro))[0], 6);
  }
}

TEST(ResamplingUnits, HaveTheMeanScoresAndWeightsOfClassesOrQueries) {
  const UnitValues of_classes = unit_values_of(values, classes, ResamplingUnit::classes, Average::micro);
  EXPECT_EQ(of_classes.values, (Eigen::MatrixXd(2, 1) << 2, 10).finished());
  EXPECT_EQ(of_classes.weights, (Eigen::VectorXd(2) << 0.75, 0.25).finished());
  EXPECT_EQ(unit_values_of(values, classes, ResamplingUnit::queries, Average::macro).weights,
            (Eigen::VectorXd(4) << 1.0 / 6, 0.5, 1.0 / 6, 1.0 / 6).finished());
}

TEST(ResamplingUnits, MeanOfWeightedContributionsIsTheAverageScore) {
  const UnitValues units = unit_values_of(values, classes, ResamplingUnit::classes, Average::micro);
  EXPECT_DOUBLE_EQ(contributions(units.values.col(0), units.weights).mean(), 4);
}

TEST(ResamplingUnits, ConvertToAndFromNames) {
  for (const std::string& name : list_of_words<ResamplingUnit>())
    EXPECT_EQ(name_of(value_of_word<ResamplingUnit>(name).value()), name);
  for (const std::string& name : list_of_words<Average>())
    EXPECT_EQ(name_of(value_of_word<Average>(name).value()), name);
  EXPECT_FALSE(value_of_word<ResamplingUnit>("models"));
  EXPECT_FALSE(value_of_word<Average>("mean"));
}

TEST(ResamplingUnits, RejectInputsOfDifferentSizes) {
  EXPECT_THROW(unit_values_of(values, std::vector<int>{1}, ResamplingUnit::classes, Average::micro), ArgumentError);
  EXPECT_THROW(unit_values_of(Eigen::MatrixXd(0, 1), {}, ResamplingUnit::classes, Average::micro), ArgumentError);
}

UnitValues example() {
  const SimulatedMethods methods = simulated_methods(30, 5, 3);
  return unit_values_of(methods.per_query, methods.classes, ResamplingUnit::classes, Average::micro);
}

TEST(Bootstrap, DoesNotDependOnTheNumberingOfClasses) {
  const SimulatedMethods methods = simulated_methods(30, 5, 3);
  std::vector<int> renumbered;
  for (const int label : methods.classes) renumbered.push_back((7 * label + 11) % 30);
  for (const Average average : {Average::micro, Average::macro}) {
    const UnitValues units = unit_values_of(methods.per_query, methods.classes, ResamplingUnit::classes, average);
    const UnitValues others = unit_values_of(methods.per_query, renumbered, ResamplingUnit::classes, average);
    EXPECT_EQ(bootstrap_averages(units, {.resamples = 100}), bootstrap_averages(others, {.resamples = 100}));
  }
}

/// Percentile interval of the averages 1 to 99.
ConfidenceInterval interval_of_percents(Eigen::Index units, double confidence) {
  Eigen::MatrixXd resampled(99, 1);
  for (Eigen::Index i = 0; i < 99; ++i) resampled(i, 0) = static_cast<double>(37 * (i + 1) % 99 + 1);  // in any order
  return percentile_intervals(resampled, units, confidence).front();
}

double normal_percent_below(double z) { return 50 * std::erfc(-z / std::sqrt(2.0)); }

TEST(Bootstrap, PercentilesMatchAHandComputation) {
  // Of Student's t with 1 degree of freedom 75 % are below 1, with 2 degrees 90 % below 0.8 / sqrt(0.18).
  const double two = normal_percent_below(-std::sqrt(2.0 / 1) * 1);
  const double three = normal_percent_below(-std::sqrt(3.0 / 2) * 0.8 / std::sqrt(0.18));
  EXPECT_NEAR(two, 7.865, 1e-3);
  EXPECT_NEAR(three, 1.046, 1e-3);
  EXPECT_NEAR(interval_of_percents(2, 0.5).low, two, 1e-9);
  EXPECT_NEAR(interval_of_percents(2, 0.5).high, 100 - two, 1e-9);
  EXPECT_NEAR(interval_of_percents(3, 0.8).low, three, 1e-9);
  EXPECT_NEAR(interval_of_percents(3, 0.8).high, 100 - three, 1e-9);
  EXPECT_EQ(interval_of_percents(2, 0.99).low, 1) << "beyond the least it is the least";
  EXPECT_EQ(interval_of_percents(2, 0.99).high, 99);
}

TEST(Bootstrap, DependsOnTheSeed) {
  EXPECT_NE(bootstrap_averages(example(), {.resamples = 500, .seed = 9}),
            bootstrap_averages(example(), {.resamples = 500, .seed = 10}));
}

TEST(Bootstrap, ResamplesHaveTheStandardErrorOfTheMean) {
  const UnitValues units = example();
  const Eigen::MatrixXd averages = bootstrap_averages(units, {.resamples = 20000});
  const auto spread = [](const Eigen::VectorXd& v) { return std::sqrt((v.array() - v.mean()).square().mean()); };
  const double standard_error = spread(units.values.col(0)) / std::sqrt(30.0);
  EXPECT_NEAR(averages.col(0).mean(), averages_of(units)[0], 4 * standard_error / std::sqrt(20000.0));
  EXPECT_NEAR(spread(averages.col(0)) / standard_error, 1, 0.03);  // four standard deviations of the ratio
}

TEST(Bootstrap, ConfidenceIntervalOfEqualScoresHasWidthZero) {
  const UnitValues units{Eigen::MatrixXd::Constant(7, 1, 0.5), Eigen::VectorXd::Constant(7, 1.0 / 7)};
  const ConfidenceInterval interval = bootstrap_intervals(units).front();
  EXPECT_DOUBLE_EQ(interval.low, 0.5);
  EXPECT_DOUBLE_EQ(interval.high, 0.5);
}

TEST(Bootstrap, IntervalIsWiderForHigherConfidence) {
  const ConfidenceInterval narrow = bootstrap_intervals(example(), 0.8).front();
  const ConfidenceInterval wide = bootstrap_intervals(example(), 0.99).front();
  EXPECT_LT(wide.low, narrow.low);
  EXPECT_GT(wide.high, narrow.high);
}

TEST(Bootstrap, RejectsASingleUnitZeroResamplesAndConfidenceOutOfRange) {
  const UnitValues one{Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Ones(1)};
  EXPECT_THROW(bootstrap_intervals(one), ArgumentError);
  EXPECT_THROW(bootstrap_intervals(example(), 0), ArgumentError);
  EXPECT_THROW(bootstrap_intervals(example(), 1), ArgumentError);
  EXPECT_THROW(bootstrap_intervals(example(), 0.95, {.resamples = 0}), ArgumentError);
}

// Fraction of data sets whose interval contains the true average, 0.6.
double coverage(ResamplingUnit unit, int data_sets) {
  int covered = 0;
  for (int i = 0; i < data_sets; ++i) {
    const SimulatedMethods methods = simulated_methods(30, 10, static_cast<unsigned>(i));
    const UnitValues units = unit_values_of(methods.per_query, methods.classes, unit, Average::micro);
    const ConfidenceInterval interval = bootstrap_intervals(units, 0.95, {.resamples = 500}).front();
    if (interval.low <= 0.6 && 0.6 <= interval.high) ++covered;
  }
  return static_cast<double>(covered) / data_sets;
}

// 600 data sets: the count of a true 95 % has a standard deviation of 0.9 %.
TEST(Bootstrap, IntervalsFromResampledClassesHaveNominalCoverage) {
  EXPECT_NEAR(coverage(ResamplingUnit::classes, 600), 0.95, 3 * 0.0089);
}

// Reason for resampling classes by default: queries of a class are correlated. A class of 10 queries that share
// half of the variance counts for 10 / (1 + 9 / 2) = 1.8 independent ones: intervals are 2.35 times too narrow, which
// leaves 60 %.
TEST(Bootstrap, IntervalsFromResampledQueriesAreTooNarrowIfQueriesOfAClassCorrelate) {
  EXPECT_NEAR(coverage(ResamplingUnit::queries, 300), 0.60, 3 * 0.028);
}

}  // namespace

}  // namespace shapegauge
