// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/histogram.h"
#include "shapegauge/retrieval/l1_distance.h"

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

TEST(Histogram, BinsIncludeTheirLowerBoundAndTheLastAlsoItsUpperBound) {
  const auto result = histogram(evenly_weighted({0, 1, 2, 3, 4}), {0, 4}, with_bins(4));
  EXPECT_EQ(bins_of(result), (std::vector<float>{0.2F, 0.2F, 0.2F, 0.4F}));
}

TEST(Histogram, CountsValuesBeyondTheRangeInTheOuterBins) {
  const auto result = histogram(evenly_weighted({-infinity, -1e300, 0.5, 1e300, infinity}), {0, 0.9}, with_bins(3));
  EXPECT_EQ(bins_of(result), (std::vector<float>{0.4F, 0.2F, 0.4F}));
}

TEST(Histogram, IgnoresNanValuesAndValuesOfZeroWeight) {
  const auto result = histogram(field_of({nan, 0.1, 0.9, 0.9}, {5, 1, 0, 1}), {0, 1}, with_bins(2));
  EXPECT_EQ(bins_of(result), (std::vector<float>{0.5F, 0.5F}));
}

TEST(Histogram, PutsAllValuesInTheFirstBinIfTheyDifferOnlyByRounding) {
  const double above = 1 + 4e-16;
  EXPECT_EQ(bins_of(histogram(evenly_weighted({1, above}), {1, above}, with_bins(3))), (std::vector<float>{1, 0, 0}));
  EXPECT_EQ(bins_of(histogram(evenly_weighted({1, 1 + 2e-9}), {1, 1 + 2e-9}, with_bins(2))),
            (std::vector<float>{0.5F, 0.5F}));
  EXPECT_EQ(bins_of(histogram(evenly_weighted({0, 1e-12}), {0, 1e-12}, with_bins(2))),
            (std::vector<float>{0.5F, 0.5F}));
  const auto result = histogram(evenly_weighted({2, 2, 2}), {2, 2}, with_bins(3));
  EXPECT_EQ(bins_of(result), (std::vector<float>{1, 0, 0}));
}

TEST(Histogram, RejectsFieldsWithoutValuesOrWithInvalidWeights) {
  const Interval range{0, 1};
  EXPECT_THROW(histogram(evenly_weighted({}), range, {}), ArgumentError);
  EXPECT_THROW(histogram(evenly_weighted({nan, nan}), range, {}), ArgumentError);
  EXPECT_THROW(histogram(field_of({1, 2}, {0, 0}), range, {}), ArgumentError);
  EXPECT_THROW(histogram(field_of({1, 2}, {1}), range, {}), ArgumentError);
  EXPECT_THROW(histogram(field_of({1}, {-1}), range, {}), ArgumentError);
  EXPECT_THROW(histogram(field_of({1}, {nan}), range, {}), ArgumentError);
  EXPECT_THROW(histogram(field_of({1}, {infinity}), range, {}), ArgumentError);
  EXPECT_THROW(histogram(field_of({1, 1}, {1e308, 1e308}), range, {}), ArgumentError);
}

TEST(Histogram, RefusesOptionsOutOfRange) {
  const ScalarField field = evenly_weighted({1});
  EXPECT_THROW(histogram(field, {0, 1}, with_bins(0)), ArgumentError);
  EXPECT_THROW(histogram(field, {1, 0}, {}), ArgumentError);
  EXPECT_THROW(histogram(field, {nan, 1}, {}), ArgumentError);
  EXPECT_THROW(histogram(field, {0, infinity}, {}), ArgumentError);
  EXPECT_THROW(histogram(field, {-1e308, 1e308}, {}), ArgumentError);
  for (const double smoothing : {-1.0, nan, infinity, 81.0}) {
    HistogramOptions options;
    options.smoothing_bins = smoothing;
    EXPECT_THROW(histogram(field, {0, 1}, options), ArgumentError) << smoothing;
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

TEST(ValueRange, EnclosesFiniteValuesOfPositiveWeight) {
  const auto range = value_range(field_of({3, nan, -infinity, infinity, -7, 5, 99}, {1, 1, 1, 1, 1, 2, 0}));
  ASSERT_TRUE(range);
  EXPECT_EQ(range->low, -7);
  EXPECT_EQ(range->high, 5);
}

TEST(ValueRange, IsEmptyWithoutValidValues) {
  EXPECT_FALSE(value_range(evenly_weighted({})));
  EXPECT_FALSE(value_range(field_of({nan, 1}, {1, 0})));
}

TEST(EnclosingInterval, IsTheSmallestThatContainsAllIntervals) {
  const std::vector<Interval> intervals = {{2, 3}, {-1, 0}, {0, 2.5}};
  const Interval enclosing = enclosing_interval(intervals);
  EXPECT_EQ(enclosing.low, -1);
  EXPECT_EQ(enclosing.high, 3);
  EXPECT_THROW(enclosing_interval({}), ArgumentError);
}

// Direct convolution: the mirrored histogram in full, summed over all offsets.
Eigen::VectorXd smoothed_naively(const Eigen::VectorXd& histogram, double standard_deviation) {
  const auto reach = static_cast<int>(std::lround(4 * standard_deviation));
  std::vector<double> once(histogram.begin(), histogram.end());
  std::vector<double> there_and_back = once;
  there_and_back.insert(there_and_back.end(), once.rbegin(), once.rend());
  std::vector<double> unrolled;
  const int copies = reach / static_cast<int>(there_and_back.size()) + 1;
  for (int copy = 0; copy < 2 * copies + 1; ++copy) {
    unrolled.insert(unrolled.end(), there_and_back.begin(), there_and_back.end());
  }
  const int origin = copies * static_cast<int>(there_and_back.size());
  Eigen::VectorXd result = Eigen::VectorXd::Zero(histogram.size());
  double total = 0;
  for (int offset = -reach; offset <= reach; ++offset) {
    const double weight = std::exp(-offset * offset / (2 * standard_deviation * standard_deviation));
    total += weight;
    for (int bin = 0; bin < static_cast<int>(histogram.size()); ++bin) {
      result[bin] += weight * unrolled[static_cast<std::size_t>(origin + bin + offset)];
    }
  }
  return result / total;
}

rc::Gen<Eigen::VectorXd> histograms() {
  return rc::gen::map(rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000))),
                      [](const std::vector<int>& counts) {
                        Eigen::VectorXd histogram(static_cast<Eigen::Index>(counts.size()));
                        for (Eigen::Index i = 0; i < histogram.size(); ++i) {
                          histogram[i] = counts[static_cast<std::size_t>(i)];
                        }
                        return histogram;
                      });
}

double deviation_up_to(Eigen::Index bins) {
  return static_cast<double>(*rc::gen::inRange<Eigen::Index>(1, bins * 100 + 1)) / 100.0;
}

TEST(GaussianSmoothing, KeepsTheHistogramUnchangedForWidthZero) {
  const Eigen::VectorXd histogram = Eigen::VectorXd::LinSpaced(5, 1, 5);
  EXPECT_EQ(smooth_gaussian(histogram, 0), histogram);
}

// At a border mass is reflected: computed by hand for unit mass in bin 0.
TEST(GaussianSmoothing, MirrorsMassAtTheBorders) {
  const Eigen::VectorXd histogram = Eigen::VectorXd::Unit(9, 0);
  const Eigen::VectorXd result = smooth_gaussian(histogram, 1);
  const auto g = [](int offset) { return std::exp(-0.5 * offset * offset); };
  const double total = g(0) + 2 * (g(1) + g(2) + g(3) + g(4));
  EXPECT_NEAR(result[0], (g(0) + g(1)) / total, 1e-15);
  EXPECT_NEAR(result[1], (g(1) + g(2)) / total, 1e-15);
  EXPECT_NEAR(result[3], (g(3) + g(4)) / total, 1e-15);
  EXPECT_NEAR(result[4], g(4) / total, 1e-15);
  EXPECT_EQ(result[5], 0);
}

TEST(GaussianSmoothing, RejectsWidthsOutOfRange) {
  const Eigen::VectorXd histogram = Eigen::VectorXd::Ones(3);
  EXPECT_THROW(smooth_gaussian(Eigen::VectorXd(), 1), ArgumentError);
  EXPECT_THROW(smooth_gaussian(histogram, -0.5), ArgumentError);
  EXPECT_THROW(smooth_gaussian(histogram, 3.5), ArgumentError);
  EXPECT_THROW(smooth_gaussian(histogram, std::numeric_limits<double>::quiet_NaN()), ArgumentError);
}

RC_GTEST_PROP(GaussianSmoothing, MatchesADirectConvolution, ()) {
  const Eigen::VectorXd histogram = *histograms();
  const double deviation = deviation_up_to(histogram.size());
  const Eigen::VectorXd difference = smooth_gaussian(histogram, deviation) - smoothed_naively(histogram, deviation);
  RC_ASSERT(difference.cwiseAbs().maxCoeff() <= 1e-12 * (1 + histogram.sum()));
}

RC_GTEST_PROP(GaussianSmoothing, KeepsAUniformHistogramUnchanged, ()) {
  const Eigen::VectorXd uniform = Eigen::VectorXd::Ones((*histograms()).size());
  RC_ASSERT((smooth_gaussian(uniform, deviation_up_to(uniform.size())) - uniform).cwiseAbs().maxCoeff() <= 1e-12);
}

Eigen::VectorXf vector_of(const std::vector<float>& entries) {
  return Eigen::Map<const Eigen::VectorXf>(entries.data(), static_cast<Eigen::Index>(entries.size()));
}

double distance_between(const Eigen::VectorXf& a, const Eigen::VectorXf& b) {
  return l1_distance({a.data(), static_cast<std::size_t>(a.size())}, {b.data(), static_cast<std::size_t>(b.size())});
}

TEST(ConcatenateHistograms, DividesEachHistogramByTheNumberOfHistograms) {
  const std::vector<Eigen::VectorXf> parts = {vector_of({0.5F, 0.5F}), vector_of({0.25F, 0.25F, 0.5F})};
  EXPECT_EQ(concatenate(parts), vector_of({0.25F, 0.25F, 0.125F, 0.125F, 0.25F}));
}

TEST(ConcatenateHistograms, KeepsTheRatioBetweenTheSumsOfHistograms) {
  const std::vector<Eigen::VectorXf> parts = {vector_of({3}), vector_of({0, 1})};
  EXPECT_EQ(concatenate(parts), vector_of({0.75F, 0, 0.25F}));
}

TEST(ConcatenateHistograms, JoinsSignaturesRowByRow) {
  const Signatures left{{1}, {2}};
  const Signatures right{{1, 0}, {0, 2}};
  const std::vector<Signatures> parts = {left, right};
  const Signatures expected{{0.5F, 0.5F, 0}, {0.5F, 0, 0.5F}};
  EXPECT_EQ(concatenate(parts), expected);
}

TEST(ConcatenateHistograms, RejectsHistogramsThatCannotBeNormalised) {
  EXPECT_THROW(concatenate(std::vector<Eigen::VectorXf>{}), ArgumentError);
  EXPECT_THROW(concatenate(std::vector<Signatures>{}), ArgumentError);
  EXPECT_THROW(concatenate(std::vector<Eigen::VectorXf>{vector_of({0, 0})}), ArgumentError);
  EXPECT_THROW(concatenate(std::vector<Eigen::VectorXf>{vector_of({1, -1, 2})}), ArgumentError);
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(concatenate(std::vector<Eigen::VectorXf>{vector_of({not_a_number})}), ArgumentError);
  const std::vector<Signatures> unequal = {Signatures::Ones(2, 1), Signatures::Ones(3, 1)};
  EXPECT_THROW(concatenate(unequal), ArgumentError);
}

RC_GTEST_PROP(ConcatenateHistograms, L1DistanceOfResultsIsTheMeanL1DistanceOfTheParts, ()) {
  const auto bins = *rc::gen::inRange<std::size_t>(1, 20);
  const auto count = *rc::gen::inRange<std::size_t>(1, 5);
  const auto random_histogram = [&] {
    const auto counts = *rc::gen::container<std::vector<int>>(bins, rc::gen::inRange(1, 100));
    Eigen::VectorXf histogram(static_cast<Eigen::Index>(bins));
    for (std::size_t i = 0; i < bins; ++i) histogram[static_cast<Eigen::Index>(i)] = static_cast<float>(counts[i]);
    return Eigen::VectorXf(histogram / histogram.sum());
  };
  std::vector<Eigen::VectorXf> a;
  std::vector<Eigen::VectorXf> b;
  double mean = 0;
  for (std::size_t i = 0; i < count; ++i) {
    a.push_back(random_histogram());
    b.push_back(random_histogram());
    mean += distance_between(a.back(), b.back()) / static_cast<double>(count);
  }
  // Entries are rounded to float: an error of 2^-24 for each unit of mass, on both sides, twice.
  RC_ASSERT(std::abs(distance_between(concatenate(a), concatenate(b)) - mean) < 1e-6);
}

}  // namespace

}  // namespace shapegauge
