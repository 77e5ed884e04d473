#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>
#include <tbb/global_control.h>

#include "shapegauge/metrics/statistics/randomisation_test.h"
#include "tests/metrics/statistics/simulated_methods.h"

namespace shapegauge {
namespace {

double p_of(const Eigen::VectorXd& differences, const ResamplingOptions& options = {}) {
  const auto count = static_cast<double>(differences.size());
  return randomisation_p_value(differences, Eigen::VectorXd::Constant(differences.size(), 1 / count), options);
}

// The p-value over all 2^n signs.
double exact_p(const Eigen::VectorXd& differences) {
  const auto n = static_cast<unsigned>(differences.size());
  int as_extreme = 0;
  for (unsigned signs = 0; signs < (1U << n); ++signs) {
    double sum = 0;
    for (unsigned i = 0; i < n; ++i) sum += ((signs >> i) & 1U) != 0 ? differences[i] : -differences[i];
    if (std::abs(sum) >= std::abs(differences.sum()) - 1e-12) ++as_extreme;
  }
  return as_extreme / std::pow(2.0, n);
}

TEST(RandomisationTest, ComesNearTheExactAnswer) {
  const Eigen::VectorXd differences = (Eigen::VectorXd(10) << .3, -.1, .2, .25, 0, .1, -.05, .3, .1, -.2).finished();
  const double exact = exact_p(differences);
  ASSERT_GT(exact, 0.02);
  EXPECT_NEAR(p_of(differences, {.resamples = 40000}), exact, 4 * std::sqrt(exact / 40000));
}

TEST(RandomisationTest, IsNeverZeroAndOneWhereNothingDiffers) {
  EXPECT_EQ(p_of(Eigen::VectorXd::Ones(200), {.resamples = 999}), 1.0 / 1000);
  EXPECT_EQ(p_of(Eigen::VectorXd::Zero(200), {.resamples = 999}), 1);
}

TEST(RandomisationTest, TakesSumsThatDifferByRoundingAsEqual) {
  // 0.1 + 0.2 - 0.3 is not 0 in binary fractions, and less than 1e-16: every sum is as far from 0.
  const Eigen::VectorXd differences = (Eigen::VectorXd(3) << .1, .2, -.3).finished();
  EXPECT_EQ(p_of(differences, {.resamples = 999}), 1);
}

TEST(RandomisationTest, SameAnswerForAnyNumberOfThreads) {
  const SimulatedMethods methods = simulated_methods(30, 5, 4);
  const Eigen::VectorXd differences = methods.per_query.col(0) - methods.per_query.col(1);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return p_of(differences);
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
  EXPECT_EQ(with_threads(1), with_threads(5));
}

TEST(RandomisationTest, RefusesNoResamplesAndNoUnits) {
  EXPECT_THROW(p_of(Eigen::VectorXd::Ones(3), {.resamples = 0}), std::invalid_argument);
  EXPECT_THROW(p_of(Eigen::VectorXd(0)), std::invalid_argument);
}

double false_positive_rate(Blocks blocks, int data_sets) {
  int significant = 0;
  for (int i = 0; i < data_sets; ++i) {
    const SimulatedMethods methods = simulated_methods(30, 10, 1000 + static_cast<unsigned>(i));
    const Units units = units_of(methods.per_query, methods.classes, blocks, Average::micro);
    const Eigen::VectorXd differences = units.values.col(0) - units.values.col(1);
    if (randomisation_p_value(differences, units.weights, {.resamples = 199}) <= 0.05) ++significant;
  }
  return static_cast<double>(significant) / data_sets;
}

// 600 data sets: the count of a true 5 % has a standard deviation of 0.9 %.
TEST(RandomisationTest, OverClassesFindsADifferenceThatIsNotThereAsOftenAsItSays) {
  EXPECT_NEAR(false_positive_rate(Blocks::classes, 600), 0.05, 3 * 0.0089);
}

// Over queries, see test_bootstrap.cpp, 40 % of equally good methods are called different.
TEST(RandomisationTest, OverQueriesIsTooEager) {
  EXPECT_NEAR(false_positive_rate(Blocks::queries, 300), 0.40, 3 * 0.028);
}

}  // namespace
}  // namespace shapegauge
