// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/descriptors/joint_histogram.h"
#include "tests/retrieval/descriptors/default_settings.h"

namespace shapegauge {
namespace {

/// Two independent fields: all pairs of values of the two.
std::vector<ScalarField> all_pairs(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  std::vector<ScalarField> fields(2,
                                  {Eigen::VectorXd(a.size() * b.size()), Eigen::VectorXd::Ones(a.size() * b.size())});
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    for (Eigen::Index j = 0; j < b.size(); ++j) {
      fields[0].values[i * b.size() + j] = a[i];
      fields[1].values[i * b.size() + j] = b[j];
    }
  }
  return fields;
}

Eigen::VectorXd random_values(Eigen::Index count, std::uint64_t seed) {
  RandomNumbers random(seed);
  Eigen::VectorXd values(count);
  for (double& value : values) value = random.uniform(0, 1) * random.uniform(0, 1);
  return values;
}

TEST(JointHistogram, OfIndependentFieldsIsTheProductOfTheirHistograms) {
  const std::vector<ScalarField> fields = all_pairs(random_values(50, 1), random_values(40, 2));
  const std::vector<JointAxis> axes = {{.bins = 7, .smoothing_bins = 1.5}, {.bins = 5, .smoothing_bins = 0.5}};
  const Eigen::VectorXf joint = joint_histogram(fields, axes);
  const Eigen::VectorXf first = histogram(fields[0], {0, 1}, {.bins = 7, .smoothing_bins = 1.5});
  const Eigen::VectorXf second = histogram(fields[1], {0, 1}, {.bins = 5, .smoothing_bins = 0.5});
  ASSERT_EQ(joint.size(), 35);
  for (Eigen::Index i = 0; i < 7; ++i) {
    for (Eigen::Index j = 0; j < 5; ++j) EXPECT_NEAR(joint[5 * i + j], first[i] * second[j], 1e-7);
  }
}

TEST(JointHistogram, SummedOverAnAxisIsTheHistogramOfTheOtherField) {
  std::vector<ScalarField> fields(3);
  for (std::size_t k = 0; k < 3; ++k) fields[k] = {random_values(200, k + 1), random_values(200, 9)};
  fields[1].values = fields[0].values.cwiseAbs2();  // not independent
  const std::vector<JointAxis> axes = {{.bins = 4}, {.bins = 6}, {.bins = 3}};
  const Eigen::VectorXf joint = joint_histogram(fields, axes);
  const Eigen::VectorXf middle = histogram(fields[1], {0, 1}, {.bins = 6, .smoothing_bins = 1});
  for (Eigen::Index j = 0; j < 6; ++j) {
    float sum = 0;
    for (Eigen::Index i = 0; i < 4; ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) sum += joint[(i * 6 + j) * 3 + k];
    }
    EXPECT_NEAR(sum, middle[j], 1e-6);
  }
}

TEST(JointHistogram, SquareRootOptionGivesTheRootsOfThePlainHistogram) {
  const std::vector<ScalarField> fields = all_pairs(random_values(50, 1), random_values(40, 2));
  const std::vector<JointAxis> axes = {{.bins = 7, .smoothing_bins = 1.5}, {.bins = 5}};
  const Eigen::VectorXf roots = joint_histogram(fields, axes, {.square_roots = true});
  EXPECT_LT((roots.cwiseAbs2() - joint_histogram(fields, axes)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(JointHistogram, WithValuesDividedByTheirMeanIsScaleInvariant) {
  std::vector<ScalarField> fields = all_pairs(random_values(50, 1), random_values(40, 2));
  const std::vector<JointAxis> axes = {{.bins = 8}, {.bins = 8, .divide_by_mean = true, .low = 0.5, .high = 2}};
  const Eigen::VectorXf before = joint_histogram(fields, axes);
  fields[1].values *= 8;
  EXPECT_EQ(joint_histogram(fields, axes), before);
  fields[0].values *= 8;
  EXPECT_NE(joint_histogram(fields, axes), before);
}

TEST(JointHistogram, UsesTheRangeOfEachShapeOnRequest) {
  std::vector<ScalarField> fields = all_pairs(random_values(50, 1), random_values(40, 2));
  const std::vector<JointAxis> axes = {{.bins = 8, .per_shape = true}, {.bins = 8}};
  const Eigen::VectorXf before = joint_histogram(fields, axes);
  fields[0].values = (16 * fields[0].values).array() + 4;
  EXPECT_LT((joint_histogram(fields, axes) - before).cwiseAbs().maxCoeff(), 1e-6);
  const Interval range = joint_range(fields[0], false);
  const std::vector<JointAxis> fixed = {{.bins = 8, .low = range.low, .high = range.high}, {.bins = 8}};
  EXPECT_EQ(joint_histogram(fields, fixed), joint_histogram(fields, axes));
}

TEST(JointHistogram, IgnoresSamplesWithMissingValues) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<ScalarField> fields = {{Eigen::Vector3d(0.1, nan, 0.9), Eigen::Vector3d(1, 5, 3)},
                                     {Eigen::Vector3d(0.1, 0.1, 0.9), Eigen::Vector3d(1, 5, 3)}};
  const std::vector<JointAxis> axes(2, {.bins = 2, .smoothing_bins = 0});
  EXPECT_EQ(joint_histogram(fields, axes), (Eigen::Vector4f{0.25F, 0, 0, 0.75F}));
  fields[1].values[0] = nan;
  EXPECT_EQ(joint_histogram(fields, axes), (Eigen::Vector4f{0, 0, 0, 1}));
}

TEST(JointHistogram, CountsValuesBeyondTheRangeInTheOuterBins) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<ScalarField> fields = {{Eigen::Vector2d(-infinity, 7), Eigen::Vector2d(1, 1)},
                                           {Eigen::Vector2d(infinity, -1), Eigen::Vector2d(1, 1)}};
  const std::vector<JointAxis> axes(2, {.bins = 2, .smoothing_bins = 0});
  EXPECT_EQ(joint_histogram(fields, axes), (Eigen::Vector4f{0, 0.5F, 0.5F, 0}));
}

TEST(JointHistogram, UsesTheValueRangeOfTheDataSetOnRequest) {
  const std::vector<ScalarField> small = all_pairs(random_values(50, 1), random_values(40, 2));
  std::vector<ScalarField> large = small;
  large[0].values *= 3;
  const Shape none;
  const std::vector<DescriptorInput> inputs = {{none, small}, {none, large}};
  const Descriptor& joint = descriptors().at("joint_histogram");
  DescriptorSettings settings = default_settings(joint, 2);
  settings.axes[0].set("bins", std::int64_t{6});
  settings.axes[0].set("over_data_set", true);
  settings.axes[1].set("bins", std::int64_t{4});
  const LearntFeatures learnt = joint.learn(inputs, settings);
  const Interval range = joint_range(large[0], false);
  const double low = joint_range(small[0], false).low;
  const std::vector<JointAxis> expected = {
      {.bins = 6, .low = static_cast<float>(low), .high = static_cast<float>(range.high)}, {.bins = 4}};
  EXPECT_EQ(joint.describe(inputs[0], learnt, settings), joint_histogram(small, expected));
}

TEST(JointHistogram, DoesNotChangeIfAConstantFieldVariesByRounding) {
  std::vector<ScalarField> fields = all_pairs(random_values(50, 1), random_values(40, 2));
  const Shape none;
  const Descriptor& joint = descriptors().at("joint_histogram");
  DescriptorSettings settings = default_settings(joint, 2);
  settings.axes[0].set("per_shape", true);
  fields[0].values.setConstant(1);
  const Eigen::VectorXf constant = compute_features(joint, {none, fields}, {}, settings);
  fields[0].values[7] += 4e-16;
  EXPECT_EQ(compute_features(joint, {none, fields}, {}, settings), constant);
}

TEST(JointHistogram, UsesTheRangeOfEachShapeIfTheDataSetRangeIsASingleValue) {
  std::vector<ScalarField> fields = all_pairs(random_values(50, 1), random_values(40, 2));
  fields[0].values.setConstant(0.7);
  const Shape none;
  const std::vector<DescriptorInput> inputs = {{none, fields}, {none, fields}};
  const Descriptor& joint = descriptors().at("joint_histogram");
  const auto histogram_with = [&](const char* range) {
    DescriptorSettings settings = default_settings(joint, 2);
    settings.axes[0].set(range, true);
    const LearntFeatures learnt = needs_learning(joint, settings) ? joint.learn(inputs, settings) : LearntFeatures();
    return compute_features(joint, inputs[0], learnt, settings);
  };
  EXPECT_EQ(histogram_with("over_data_set"), histogram_with("per_shape"));
}

TEST(JointHistogram, DataSetRangeRefersToValuesDividedByTheMean) {
  // Values 1 to 3 with the mean 2, and 10 to 40 with the mean 20: divided by the mean 0.5 to 1.5 and 0.5 to 2.
  const std::vector<ScalarField> first = all_pairs(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(0.2, 0.4, 0.6));
  const std::vector<ScalarField> second = all_pairs(Eigen::Vector3d(10, 10, 40), Eigen::Vector3d(0.2, 0.4, 0.6));
  const Shape none;
  const std::vector<DescriptorInput> inputs = {{none, first}, {none, second}};
  const Descriptor& joint = descriptors().at("joint_histogram");
  DescriptorSettings settings = default_settings(joint, 2);
  settings.axes[0].set("over_data_set", true);
  settings.axes[0].set("divide_by_mean", true);
  settings.axes[1].set("over_data_set", true);
  const LearntFeatures learnt = joint.learn(inputs, settings);
  EXPECT_TRUE(learnt.isApprox(LearntFeatures{{0.5F, 2.0F}, {0.2F, 0.6F}}, 1e-6F)) << learnt;
}

TEST(JointHistogram, RejectsMismatchedFieldsAndAxesAndOptionsOutOfRange) {
  const std::vector<ScalarField> fields = all_pairs(random_values(5, 1), random_values(4, 2));
  const std::vector<JointAxis> axes(2);
  EXPECT_THROW(joint_histogram(std::span(fields).first(1), std::span(axes).first(1)), ArgumentError);
  EXPECT_THROW(joint_histogram(fields, std::span(axes).first(1)), ArgumentError);
  for (const JointAxis& axis :
       {JointAxis{.bins = 0}, JointAxis{.smoothing_bins = -1}, JointAxis{.low = 1, .high = 1}}) {
    EXPECT_THROW(joint_histogram(fields, std::vector{axis, JointAxis{}}), InputError);
  }
  EXPECT_THROW(joint_histogram(fields, std::vector{JointAxis{.bins = 1001}, JointAxis{.bins = 1}}), InputError);
  EXPECT_THROW(joint_histogram(fields, std::vector(3, JointAxis{})), ArgumentError);
  std::vector<ScalarField> other = fields;
  other[1].values.conservativeResize(3);
  EXPECT_THROW(joint_histogram(other, axes), ArgumentError);
  other = fields;
  other[0].weights[2] = -1;
  EXPECT_THROW(joint_histogram(other, axes), ArgumentError);
  other[0].values.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(joint_histogram(other, axes), ArgumentError);
}

TEST(JointHistogram, RangeOfValuesDividedByTheMeanUsesTheWeightedMean) {
  const ScalarField field{Eigen::Vector2d(1, 3), Eigen::Vector2d(3, 1)};  // mean 1.5
  const Interval range = joint_range(field, true);
  EXPECT_DOUBLE_EQ(range.low, 1 / 1.5);
  EXPECT_DOUBLE_EQ(range.high, 3 / 1.5);
}

TEST(JointHistogram, ShapeRangeRefersToValuesDividedByTheMean) {
  const ScalarField field{Eigen::Vector4d(1, 1.5, 3.5, 4), Eigen::Vector4d::Ones()};
  const std::vector<JointAxis> axes = {{.bins = 3, .smoothing_bins = 0, .divide_by_mean = true, .per_shape = true},
                                       {.bins = 1, .smoothing_bins = 0}};
  EXPECT_EQ(joint_histogram(std::vector{field, field}, axes), Eigen::Vector3f(0.5F, 0, 0.5F));
}

}  // namespace
}  // namespace shapegauge
