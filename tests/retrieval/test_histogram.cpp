#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <stdexcept>
#include <vector>

#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ScalarField field_of(const std::vector<double>& values, const std::vector<double>& weights) {
  ScalarField field;
  field.values = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  field.weights = Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
  return field;
}

ScalarField evenly_weighted(const std::vector<double>& values) {
  return field_of(values, std::vector<double>(values.size(), 1.0));
}

std::vector<float> bins_of(const Eigen::VectorXf& histogram) { return {histogram.begin(), histogram.end()}; }

HistogramOptions with_bins(int bins) {
  HistogramOptions options;
  options.bins = bins;
  return options;
}

TEST(Histogram, CountsEachValueByItsWeight) {
  const auto result = histogram(field_of({0.1, 0.3, 0.6, 0.9}, {1, 2, 1, 4}), {0, 1}, with_bins(2));
  EXPECT_EQ(bins_of(result), (std::vector<float>{0.375F, 0.625F}));
}

TEST(Histogram, ABinHoldsItsLowerBorderAndTheLastBinBoth) {
  const auto result = histogram(evenly_weighted({0, 1, 2, 3, 4}), {0, 4}, with_bins(4));
  EXPECT_EQ(bins_of(result), (std::vector<float>{0.2F, 0.2F, 0.2F, 0.4F}));
}

TEST(Histogram, ValuesBeyondTheRangeCountInTheOuterBins) {
  const auto result = histogram(evenly_weighted({-infinity, -1e300, 0.5, 1e300, infinity}), {0, 0.9}, with_bins(3));
  EXPECT_EQ(bins_of(result), (std::vector<float>{0.4F, 0.2F, 0.4F}));
}

TEST(Histogram, NanAndWeightZeroDoNotCount) {
  const auto result = histogram(field_of({nan, 0.1, 0.9, 0.9}, {5, 1, 0, 1}), {0, 1}, with_bins(2));
  EXPECT_EQ(bins_of(result), (std::vector<float>{0.5F, 0.5F}));
}

TEST(Histogram, ARangeOfNoWidthPutsAllInTheFirstBin) {
  const auto result = histogram(evenly_weighted({2, 2, 2}), {2, 2}, with_bins(3));
  EXPECT_EQ(bins_of(result), (std::vector<float>{1, 0, 0}));
}

TEST(Histogram, RefusesWhatHasNoHistogram) {
  const Interval range{0, 1};
  EXPECT_THROW(histogram(evenly_weighted({}), range, {}), std::invalid_argument);
  EXPECT_THROW(histogram(evenly_weighted({nan, nan}), range, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field_of({1, 2}, {0, 0}), range, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field_of({1, 2}, {1}), range, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field_of({1}, {-1}), range, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field_of({1}, {nan}), range, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field_of({1}, {infinity}), range, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field_of({1, 1}, {1e308, 1e308}), range, {}), std::invalid_argument);
}

TEST(Histogram, RefusesOptionsOutOfRange) {
  const ScalarField field = evenly_weighted({1});
  EXPECT_THROW(histogram(field, {0, 1}, with_bins(0)), std::invalid_argument);
  EXPECT_THROW(histogram(field, {1, 0}, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field, {nan, 1}, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field, {0, infinity}, {}), std::invalid_argument);
  EXPECT_THROW(histogram(field, {-1e308, 1e308}, {}), std::invalid_argument);
  for (const double smoothing : {-1.0, nan, infinity, 81.0}) {
    HistogramOptions options;
    options.smoothing_bins = smoothing;
    EXPECT_THROW(histogram(field, {0, 1}, options), std::invalid_argument) << smoothing;
  }
}

TEST(Histogram, SmoothingSpreadsMassAndKeepsTheSum) {
  HistogramOptions options = with_bins(9);
  options.smoothing_bins = 1;
  const Eigen::VectorXf result = histogram(evenly_weighted({0.5}), {0, 1}, options);
  EXPECT_NEAR(result.sum(), 1, 1e-6);
  // The normal density at 0, to which the kernel's normalisation over whole bins comes very close.
  EXPECT_NEAR(result[4], 1 / std::sqrt(2 * std::acos(-1.0)), 1e-4);
  EXPECT_FLOAT_EQ(result[3], result[5]);
}

RC_GTEST_PROP(Histogram, SumsToOneAndDoesNotDependOnTheScaleOfWeights, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(1, 200);
  const auto number = [](int low, int high) {
    return rc::gen::map(rc::gen::inRange(low, high), [](int n) { return n / 1000.0; });
  };
  const auto values = *rc::gen::container<std::vector<double>>(size, number(-2000, 4000));
  auto weights = *rc::gen::container<std::vector<double>>(size, number(0, 1000));
  weights[0] = 0.5;
  HistogramOptions options = with_bins(*rc::gen::inRange(1, 100));
  options.smoothing_bins = *number(0, options.bins * 1000 + 1);
  const ScalarField field = field_of(values, weights);
  const Eigen::VectorXf result = histogram(field, {0, 1}, options);
  RC_ASSERT(result.size() == options.bins);
  RC_ASSERT(result.minCoeff() >= 0.0F);
  RC_ASSERT(std::abs(result.cast<double>().sum() - 1) < 1e-6);
  ScalarField scaled = field;
  scaled.weights *= 1024;  // a power of two: exact
  RC_ASSERT(histogram(scaled, {0, 1}, options) == result);
}

TEST(ValueRange, IsThatOfFiniteValuesOfPositiveWeight) {
  const auto range = value_range(field_of({3, nan, -infinity, infinity, -7, 5, 99}, {1, 1, 1, 1, 1, 2, 0}));
  ASSERT_TRUE(range);
  EXPECT_EQ(range->low, -7);
  EXPECT_EQ(range->high, 5);
}

TEST(ValueRange, IsNothingWhereNothingCounts) {
  EXPECT_FALSE(value_range(evenly_weighted({})));
  EXPECT_FALSE(value_range(field_of({nan, 1}, {1, 0})));
}

TEST(EnclosingInterval, HoldsAllIntervalsTightly) {
  const std::vector<Interval> intervals = {{2, 3}, {-1, 0}, {0, 2.5}};
  const Interval enclosing = enclosing_interval(intervals);
  EXPECT_EQ(enclosing.low, -1);
  EXPECT_EQ(enclosing.high, 3);
  EXPECT_THROW(enclosing_interval({}), std::invalid_argument);
}

}  // namespace
}  // namespace shapegauge
