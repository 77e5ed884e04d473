#include <gtest/gtest.h>
#include <random>
#include <stdexcept>

#include "shapegauge/metrics/statistics/randomisation_test.h"
#include "shapegauge/metrics/statistics/tukey_hsd.h"
#include "tests/metrics/statistics/simulated_methods.h"

namespace shapegauge {
namespace {

Units random_units(Eigen::Index units, Eigen::Index methods, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return {Eigen::MatrixXd::NullaryExpr(units, methods, [&] { return normal(random); }),
          Eigen::VectorXd::Constant(units, 1.0 / static_cast<double>(units))};
}

TEST(TukeyHsd, OfTwoMethodsIsTheRandomisationTest) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Units units = random_units(30, 2, seed);
    const double p = randomisation_p_value(units.values.col(0) - units.values.col(1), units.weights);
    // Two estimates of one probability, of 10,000 draws each.
    EXPECT_NEAR(tukey_hsd_p_values(units)(0, 1), p, 4 * std::sqrt(2 * p * (1 - p) / 10000));
  }
}

TEST(TukeyHsd, FindsTheMethodThatIsDifferent) {
  Units units = random_units(40, 4, 5);
  units.values.col(2).array() += 3;
  const Eigen::MatrixXd p = tukey_hsd_p_values(units, {.resamples = 999});
  for (const Eigen::Index other : {0, 1, 3}) {
    EXPECT_EQ(p(2, other), 0.001);
    EXPECT_EQ(p(other, 2), 0.001);
  }
  EXPECT_GT(p(0, 1), 0.05);
  EXPECT_EQ(p(1, 1), 1);
}

TEST(TukeyHsd, EqualMethodsAreNotDifferent) {
  Units units = random_units(40, 3, 6);
  units.values.col(1) = units.values.col(0);
  EXPECT_EQ(tukey_hsd_p_values(units)(0, 1), 1);
}

// Any pair of five equally good methods below 5 %: in 5 % of 400 data sets, with a standard deviation of 1.1 %.
TEST(TukeyHsd, GoesWrongAnywhereAsOftenAsItSays) {
  int wrong = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    if (tukey_hsd_p_values(random_units(20, 5, seed), {.resamples = 199}).minCoeff() <= 0.05) ++wrong;
  }
  EXPECT_NEAR(wrong / 400.0, 0.05, 3 * 0.0109);
}

TEST(TukeyHsd, RefusesNoResamples) {
  EXPECT_THROW(tukey_hsd_p_values(random_units(3, 2, 1), {.resamples = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace shapegauge
