// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "tests/retrieval/descriptors/default_settings.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(Descriptors, HaveUniqueNamesAndValidDefaults) {
  std::set<std::string_view> names;
  for (const Descriptor& one : descriptors().entries()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_FALSE(one.description.empty());
    EXPECT_LE(one.min_fields, one.max_fields);
    for (const auto& parameters : {one.parameters, one.axis_parameters}) {
      for (const Parameter& parameter : parameters) {
        EXPECT_NO_THROW(validate_value(parameter, parameter.default_value)) << one.name << " " << parameter.name;
        EXPECT_FALSE(parameter.description.empty());
      }
    }
  }
}

TEST(Descriptors, GiveAShapeTheDistanceZeroToItself) {
  const Shape shape = test::capsule(0.3, 1, 16, 16);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  const std::vector<ScalarField> fields = {{samples.points.col(0), samples.weights},
                                           {samples.points.col(2), samples.weights}};
  for (const Descriptor& one : descriptors().entries()) {
    const DescriptorInput input = {shape, std::span(fields).first(std::min<std::size_t>(one.max_fields, 2))};
    const DescriptorSettings settings = default_settings(one, input.fields.size());
    const LearntFeatures learnt = needs_learning(one, settings) ? one.learn({&input, 1}, settings) : LearntFeatures{};
    const Eigen::VectorXf features = one.describe(input, learnt, settings);
    EXPECT_TRUE(features.allFinite()) << one.name;
    const std::span<const float> entries(features.data(), static_cast<std::size_t>(features.size()));
    EXPECT_EQ(one.distance(entries, entries), 0) << one.name;
  }
}

TEST(Descriptors, RejectNonFiniteFeatures) {
  const Shape shape = test::sphere(1, 1);
  Descriptor broken = descriptors().at("d2");
  const auto features = [&] { return compute_features(broken, {shape, {}}, {}, default_settings(broken)); };
  EXPECT_TRUE(features().allFinite());
  broken.describe = [](const DescriptorInput&, const LearntFeatures&, const DescriptorSettings&) {
    return Eigen::VectorXf(Eigen::Vector2f(1, std::numeric_limits<float>::infinity()));
  };
  EXPECT_THROW(features(), InputError);
  broken.describe = [](const DescriptorInput&, const LearntFeatures&, const DescriptorSettings&) {
    return Eigen::VectorXf();
  };
  EXPECT_THROW(features(), InputError);
}

TEST(Descriptors, RegisteredD2UsesTheGivenNumberOfBins) {
  const Shape shape = test::sphere(1, 2);
  const Descriptor& one = descriptors().at("d2");
  DescriptorSettings settings = default_settings(one);
  settings.values.set("bins", std::int64_t{10});
  EXPECT_EQ(one.describe({shape, {}}, {}, settings), d2(shape, {.bins = 10}));
}

TEST(Descriptors, RejectOptionsOutOfRangeAndUnknownNames) {
  const Shape shape = test::sphere(1, 1);
  EXPECT_THROW(d2(shape, {.bins = 0}), InputError);
  EXPECT_THROW(d2(shape, {.longest = std::nan("")}), InputError);
  EXPECT_EQ(descriptors().find("d3"), nullptr);
}

TEST(Descriptors, RejectRegistrationWithoutADistanceFunction) {
  Descriptor one = descriptors().at("d2");
  one.name = "test_without_distance";
  one.distance = nullptr;
  EXPECT_THROW(descriptors().add(one), ArgumentError);
  EXPECT_EQ(descriptors().find("test_without_distance"), nullptr);
}

TEST(Descriptors, RefuseToDescribeBeforeLearning) {
  const Shape shape = test::sphere(1, 1);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  const std::vector<ScalarField> fields(2, {samples.points.col(0), samples.weights});
  const DescriptorInput input = {shape, fields};
  const Descriptor& bag = descriptors().at("bag_of_features");
  EXPECT_THROW(bag.describe(input, {}, default_settings(bag, 2)), InputError);
  const Descriptor& joint = descriptors().at("joint_histogram");
  DescriptorSettings settings = default_settings(joint, 2);
  EXPECT_FALSE(needs_learning(joint, settings));
  settings.axes[1].set("over_data_set", true);
  EXPECT_TRUE(needs_learning(joint, settings));
  EXPECT_THROW(joint.describe(input, {}, settings), InputError);
}

TEST(DescriptorDistances, OfAFeatureMatrixMatchTheDistancesOfEachPairOfRows) {
  Signatures features{{0, 0}, {1, 2}, {4, 0}};
  const DistanceMatrix matrix = descriptor_distances(descriptors().at("d2"), features);
  EXPECT_EQ(matrix, (DistanceMatrix{{0, 3, 4}, {3, 0, 5}, {4, 5, 0}}));
  features(1, 1) = std::numeric_limits<float>::infinity();
  EXPECT_THROW(descriptor_distances(descriptors().at("d2"), features), InputError);
}

TEST(FeatureDistance, IsFoundByTheNameOfADistanceOrADescriptor) {
  EXPECT_EQ(feature_distance("chi2").function, distances().at("chi2").function);
  for (const Descriptor& one : descriptors().entries())
    EXPECT_EQ(feature_distance(std::string(one.name)).function, one.distance);
  for (const std::string& name : feature_distance_names()) EXPECT_EQ(feature_distance(name).name, name);
  EXPECT_EQ(std::ssize(feature_distance_names()), std::ssize(distances().names()) + std::ssize(descriptors().names()));
  EXPECT_THROW(feature_distance("l3"), ArgumentError);
}

}  // namespace
}  // namespace shapegauge
