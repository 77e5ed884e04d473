#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <stdexcept>
#include <vector>

#include "shapegauge/retrieval/distances/l1.h"
#include "shapegauge/retrieval/signature.h"

namespace shapegauge {
namespace {

Eigen::VectorXf vector_of(const std::vector<float>& entries) {
  return Eigen::Map<const Eigen::VectorXf>(entries.data(), static_cast<Eigen::Index>(entries.size()));
}

double distance_between(const Eigen::VectorXf& a, const Eigen::VectorXf& b) {
  return l1_distance({a.data(), static_cast<std::size_t>(a.size())}, {b.data(), static_cast<std::size_t>(b.size())});
}

TEST(Concatenate, PutsPartsSideBySideEachWithItsShare) {
  const std::vector<Eigen::VectorXf> parts = {vector_of({0.5F, 0.5F}), vector_of({0.25F, 0.25F, 0.5F})};
  EXPECT_EQ(concatenate(parts), vector_of({0.25F, 0.25F, 0.125F, 0.125F, 0.25F}));
}

TEST(Concatenate, KeepsTheProportionOfPartsOfUnequalSum) {
  const std::vector<Eigen::VectorXf> parts = {vector_of({3}), vector_of({0, 1})};
  EXPECT_EQ(concatenate(parts), vector_of({0.75F, 0, 0.25F}));
}

TEST(Concatenate, WorksRowByRow) {
  Signatures left(2, 1);
  left << 1, 2;
  Signatures right(2, 2);
  right << 1, 0, 0, 2;
  const std::vector<Signatures> parts = {left, right};
  Signatures expected(2, 3);
  expected << 0.5F, 0.5F, 0, 0.5F, 0, 0.5F;
  EXPECT_EQ(concatenate(parts), expected);
}

TEST(Concatenate, RefusesWhatCannotBeNormalised) {
  EXPECT_THROW(concatenate(std::vector<Eigen::VectorXf>{}), std::invalid_argument);
  EXPECT_THROW(concatenate(std::vector<Signatures>{}), std::invalid_argument);
  EXPECT_THROW(concatenate(std::vector<Eigen::VectorXf>{vector_of({0, 0})}), std::invalid_argument);
  EXPECT_THROW(concatenate(std::vector<Eigen::VectorXf>{vector_of({1, -1, 2})}), std::invalid_argument);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(concatenate(std::vector<Eigen::VectorXf>{vector_of({nan})}), std::invalid_argument);
  const std::vector<Signatures> unequal = {Signatures::Ones(2, 1), Signatures::Ones(3, 1)};
  EXPECT_THROW(concatenate(unequal), std::invalid_argument);
}

RC_GTEST_PROP(Concatenate, L1DistanceIsTheMeanOfThePartsDistances, ()) {
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
