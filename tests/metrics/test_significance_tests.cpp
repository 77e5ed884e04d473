// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/significance_tests.h"
#include "tests/metrics/simulated_methods.h"

namespace shapegauge {

namespace {

using testing::DoubleEq;
using testing::ElementsAre;

double p_of(const Eigen::VectorXd& differences, const ResamplingOptions& options = {}) {
  const auto count = static_cast<double>(differences.size());
  return randomisation_p_value(differences, Eigen::VectorXd::Constant(differences.size(), 1 / count), options);
}

// Exact p-value over all 2^n signs.
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

TEST(RandomisationTest, PValueApproximatesTheExactPValueOfAllSignFlips) {
  const Eigen::VectorXd differences = (Eigen::VectorXd(10) << .3, -.1, .2, .25, 0, .1, -.05, .3, .1, -.2).finished();
  const double exact = exact_p(differences);
  ASSERT_GT(exact, 0.02);
  EXPECT_NEAR(p_of(differences, {.resamples = 40000}), exact, 4 * std::sqrt(exact / 40000));
}

TEST(RandomisationTest, PValueIsPositiveAndIsOneForEqualMethods) {
  EXPECT_EQ(p_of(Eigen::VectorXd::Ones(200), {.resamples = 999}), 1.0 / 1000);
  EXPECT_EQ(p_of(Eigen::VectorXd::Zero(200), {.resamples = 999}), 1);
}

TEST(RandomisationTest, TreatsSumsThatDifferByRoundingAsEqual) {
  // 0.1 + 0.2 - 0.3 is not 0 in binary fractions, and less than 1e-16: every sum is as far from 0.
  const Eigen::VectorXd differences = (Eigen::VectorXd(3) << .1, .2, -.3).finished();
  EXPECT_EQ(p_of(differences, {.resamples = 999}), 1);
}

TEST(RandomisationTest, RejectsZeroResamplesAndEmptyInput) {
  EXPECT_THROW(p_of(Eigen::VectorXd::Ones(3), {.resamples = 0}), ArgumentError);
  EXPECT_THROW(p_of(Eigen::VectorXd(0)), ArgumentError);
}

double false_positive_rate(ResamplingUnit unit, int data_sets) {
  int significant = 0;
  for (int i = 0; i < data_sets; ++i) {
    const SimulatedMethods methods = simulated_methods(30, 10, 1000 + static_cast<unsigned>(i));
    const UnitValues units = unit_values_of(methods.per_query, methods.classes, unit, Average::micro);
    const Eigen::VectorXd differences = units.values.col(0) - units.values.col(1);
    if (randomisation_p_value(differences, units.weights, {.resamples = 199}) <= 0.05) ++significant;
  }
  return static_cast<double>(significant) / data_sets;
}

// 600 data sets: the count of a true 5 % has a standard deviation of 0.9 %.
TEST(RandomisationTest, OverClassesHasTheNominalErrorRate) {
  EXPECT_NEAR(false_positive_rate(ResamplingUnit::classes, 600), 0.05, 3 * 0.0089);
}

// Over queries, see test_bootstrap.cpp, 40 % of equally good methods are called different.
TEST(RandomisationTest, OverQueriesExceedsTheNominalErrorRateIfQueriesOfAClassCorrelate) {
  EXPECT_NEAR(false_positive_rate(ResamplingUnit::queries, 300), 0.40, 3 * 0.028);
}

// "Student"'s own data, Biometrika 1908: hours of sleep gained by one drug over another. t = 4.06 with 9 degrees of
// freedom, p = 0.00283.
TEST(PairedTTest, MatchesThePValueOfTheSleepDataOfStudent) {
  const Eigen::VectorXd gained = (Eigen::VectorXd(10) << 1.2, 2.4, 1.3, 1.3, 0, 1, 1.8, 0.8, 4.6, 1.4).finished();
  const double p = paired_t_p_value(gained);
  EXPECT_NEAR(p, 0.002833, 5e-7);
  EXPECT_DOUBLE_EQ(paired_t_p_value(-gained), p);
}

TEST(PairedTTest, HasPValueZeroOrOneForConstantDifferences) {
  EXPECT_EQ(paired_t_p_value(Eigen::VectorXd::Zero(5)), 1);
  EXPECT_EQ(paired_t_p_value(Eigen::VectorXd::Constant(4, -0.5)), 0);
}

TEST(PairedTTest, RejectsASingleDifference) { EXPECT_THROW(paired_t_p_value(Eigen::VectorXd::Ones(1)), ArgumentError); }

UnitValues random_units(Eigen::Index units, Eigen::Index methods, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return {Eigen::MatrixXd::NullaryExpr(units, methods, [&] { return normal(random); }),
          Eigen::VectorXd::Constant(units, 1.0 / static_cast<double>(units))};
}

TEST(TukeyHsd, MatchesTheRandomisationTestForTwoMethods) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const UnitValues units = random_units(30, 2, seed);
    const double p = randomisation_p_value(units.values.col(0) - units.values.col(1), units.weights);
    // Two estimates of one probability, of 10,000 draws each.
    EXPECT_NEAR(tukey_hsd_p_values(units)(0, 1), p, 4 * std::sqrt(2 * p * (1 - p) / 10000));
  }
}

TEST(TukeyHsd, FindsTheOneMethodThatDiffers) {
  UnitValues units = random_units(40, 4, 5);
  units.values.col(2).array() += 3;
  const Eigen::MatrixXd p = tukey_hsd_p_values(units, {.resamples = 999});
  for (const Eigen::Index other : {0, 1, 3}) {
    EXPECT_EQ(p(2, other), 0.001);
    EXPECT_EQ(p(other, 2), 0.001);
  }
  EXPECT_GT(p(0, 1), 0.05);
  EXPECT_EQ(p(1, 1), 1);
}

TEST(TukeyHsd, HasPValueOneForEqualMethods) {
  UnitValues units = random_units(40, 3, 6);
  units.values.col(1) = units.values.col(0);
  EXPECT_EQ(tukey_hsd_p_values(units)(0, 1), 1);
}

// Any pair of five equally good methods below 5 %: in 5 % of 400 data sets, with a standard deviation of 1.1 %.
TEST(TukeyHsd, HasTheNominalFamilywiseErrorRate) {
  int wrong = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    if (tukey_hsd_p_values(random_units(20, 5, seed), {.resamples = 199}).minCoeff() <= 0.05) ++wrong;
  }
  EXPECT_NEAR(wrong / 400.0, 0.05, 3 * 0.0109);
}

TEST(TukeyHsd, HasTheSmallestPossiblePValueIfAllUnitsAgree) {
  EXPECT_DOUBLE_EQ(min_attainable_tukey_p_value(2, 5, {}), 1.0 / 16);
  EXPECT_DOUBLE_EQ(min_attainable_tukey_p_value(3, 3, {}), 1.0 / 36);
  EXPECT_EQ(min_attainable_tukey_p_value(26, 6, {.resamples = 999}), 0.001);
  EXPECT_EQ(min_attainable_tukey_p_value(1, 9, {}), 1);
  EXPECT_EQ(min_attainable_tukey_p_value(9, 1, {}), 1);
  const UnitValues agreed{Eigen::RowVector3d(0.1, 0.5, 0.9).replicate(3, 1), Eigen::Vector3d::Constant(1.0 / 3)};
  EXPECT_NEAR(tukey_hsd_p_values(agreed)(0, 2), 1.0 / 36, 4 * std::sqrt(1.0 / 36 / 10000));
  for (unsigned seed = 0; seed < 5; ++seed) {  // sums that differ by rounding are equal
    UnitValues units = random_units(8, 2, seed);
    units.values.col(0) = units.values.col(0).cwiseAbs();
    units.values.col(1).setZero();
    EXPECT_NEAR(tukey_hsd_p_values(units)(0, 1), 1.0 / 128, 4 * std::sqrt(1.0 / 128 / 10000)) << seed;
  }
}

TEST(TukeyHsd, RejectsZeroResamples) {
  EXPECT_THROW(tukey_hsd_p_values(random_units(3, 2, 1), {.resamples = 0}), ArgumentError);
}

TEST(HolmAdjustment, IsMonotoneInAscendingOrderOfPValues) {
  // Ascending: 0.01 * 4, 0.02 * 3, 0.025 * 2 (less than the one before), 0.5 * 1.
  EXPECT_THAT(adjust_by_holm(std::vector<double>{0.5, 0.01, 0.025, 0.02}),
              ElementsAre(DoubleEq(0.5), DoubleEq(0.04), DoubleEq(0.06), DoubleEq(0.06)));
}

TEST(HolmAdjustment, IsAtMostOneAndKeepsASinglePValue) {
  EXPECT_THAT(adjust_by_holm(std::vector<double>{0.4, 0.6, 0.9}), ElementsAre(1, 1, 1));
  EXPECT_THAT(adjust_by_holm(std::vector<double>{0.03}), ElementsAre(0.03));
  EXPECT_TRUE(adjust_by_holm(std::vector<double>{}).empty());
}

TEST(EffectSize, IsTheMeanDifferenceInStandardDeviations) {
  // Mean 2, squared deviations 1 + 0 + 1, over n - 1 = 2: a standard deviation of 1.
  EXPECT_DOUBLE_EQ(effect_size((Eigen::VectorXd(3) << 1, 2, 3).finished()), 2);
  EXPECT_EQ(effect_size(Eigen::VectorXd::Zero(3)), 0);
  EXPECT_TRUE(std::isinf(effect_size(Eigen::VectorXd::Ones(3))));
  EXPECT_TRUE(std::isinf(effect_size(Eigen::Vector3d(0.5 - 0.4, 0.4 - 0.3, 0.3 - 0.2)))) << "equal up to rounding";
  EXPECT_THROW(effect_size(Eigen::VectorXd::Ones(1)), ArgumentError);
}

TEST(WinTieLoss, CountsTheSignsOfDifferences) {
  const WinTieLoss counts = win_tie_loss((Eigen::VectorXd(6) << 1, 0, -2, 0.5, 0, 3).finished());
  EXPECT_EQ(counts.wins, 3);
  EXPECT_EQ(counts.ties, 2);
  EXPECT_EQ(counts.losses, 1);
}

}  // namespace

}  // namespace shapegauge
