#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(Descriptors, HaveNamesOfTheirOwnAndDefaultsWithinTheirBounds) {
  std::set<std::string_view> names;
  for (const Descriptor& one : descriptors()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_FALSE(one.meaning.empty());
    EXPECT_LE(one.fewest_fields, one.most_fields);
    for (const DescriptorParameter& parameter : one.parameters) {
      EXPECT_NO_THROW(require_allowed(one.name, parameter, parameter.fallback)) << one.name << " " << parameter.name;
      EXPECT_FALSE(parameter.meaning.empty());
    }
  }
}

TEST(Descriptors, EachDescribesAShapeAndIsZeroFromItself) {
  const Shape shape = test::capsule(0.3, 1, 16, 16);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  const std::vector<ScalarField> fields = {{samples.points.col(0), samples.weights},
                                           {samples.points.col(2), samples.weights}};
  for (const Descriptor& one : descriptors()) {
    const DescriptorInput input = {shape, std::span(fields).first(std::min<std::size_t>(one.most_fields, 2))};
    const LearntFeatures learnt = one.learn == nullptr ? LearntFeatures{} : one.learn({&input, 1}, {});
    const Eigen::VectorXf features = one.describe(input, learnt, {});
    EXPECT_TRUE(features.allFinite()) << one.name;
    const std::span<const float> entries(features.data(), static_cast<std::size_t>(features.size()));
    EXPECT_EQ(one.distance(entries, entries), 0) << one.name;
  }
}

TEST(Descriptors, SettingsChangeWhatTheySay) {
  const Shape shape = test::sphere(1, 2);
  const Descriptor& one = descriptor("d2");
  EXPECT_EQ(one.describe({shape, {}}, {}, {{"bins", 10}}), d2(shape, {.bins = 10}));
}

TEST(Descriptors, RefuseSettingsThatAreNone) {
  const Shape shape = test::sphere(1, 1);
  const Descriptor& one = descriptor("d2");
  for (const DescriptorSettings& settings :
       {DescriptorSettings{{"bins", 0}}, {{"bins", 2.5}}, {{"bin", 5}}, {{"longest", std::nan("")}}}) {
    EXPECT_THROW(one.describe({shape, {}}, {}, settings), InputError);
  }
  EXPECT_THROW(descriptor("d3"), InputError);
}

TEST(Descriptors, RefuseToDescribeBeforeTheyHaveLearnt) {
  const Shape shape = test::sphere(1, 1);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  const std::vector<ScalarField> fields(2, {samples.points.col(0), samples.weights});
  const DescriptorInput input = {shape, fields};
  EXPECT_THROW(descriptor("bag_of_features").describe(input, {}, {}), InputError);
  EXPECT_THROW(descriptor("joint_histogram").describe(input, {}, {{"axes.1.over_data_set", 1}}), InputError);
}

TEST(DescriptorDistances, AreThoseOfAllPairs) {
  Signatures features(3, 2);
  features << 0, 0, 1, 2, 4, 0;
  const DistanceMatrix matrix = descriptor_distances(descriptor("d2"), features);
  EXPECT_EQ(matrix, (DistanceMatrix{{0, 3, 4}, {3, 0, 5}, {4, 5, 0}}));
  features(1, 1) = std::numeric_limits<float>::infinity();
  EXPECT_THROW(descriptor_distances(descriptor("d2"), features), InputError);
}

}  // namespace
}  // namespace shapegauge
