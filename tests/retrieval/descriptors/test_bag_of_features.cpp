// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/descriptors/bag_of_features.h"
#include "tests/retrieval/descriptors/default_settings.h"

namespace shapegauge {
namespace {

/// Fields whose vectors are clustered about some centres, equally many about each.
std::vector<ScalarField> clustered(const std::vector<Eigen::Vector2d>& centres, std::uint64_t seed) {
  constexpr Eigen::Index each = 50;
  const Eigen::Index samples = each * std::ssize(centres);
  RandomNumbers random(seed);
  std::vector<ScalarField> fields(2, {Eigen::VectorXd(samples), Eigen::VectorXd::Ones(samples)});
  for (Eigen::Index i = 0; i < samples; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      fields[k].values[i] =
          centres[static_cast<std::size_t>(i / each)][static_cast<Eigen::Index>(k)] + random.uniform(-0.1, 0.1);
    }
  }
  return fields;
}

const std::vector<Eigen::Vector2d> corners = {{0, 0}, {0, 10}, {10, 0}};

Codebook codebook_of(const std::vector<std::vector<ScalarField>>& shapes, const BagOfFeaturesOptions& options) {
  return codebook(std::vector<ShapeFields>(shapes.begin(), shapes.end()), options);
}

TEST(Codebook, FindsTheCentresOfClusters) {
  const Codebook found = codebook_of({clustered(corners, 1), clustered(corners, 2)}, {.words = 3});
  ASSERT_EQ(found.words.rows(), 3);
  for (const Eigen::Vector2d& centre : corners) {
    const Eigen::VectorXf distances = (found.words.rowwise() - centre.transpose().cast<float>()).rowwise().norm();
    EXPECT_LT(distances.minCoeff(), 0.05);
  }
}

TEST(Codebook, DependsOnTheSeedAndNotOnTheNumberOfThreads) {
  RandomNumbers random(3);
  std::vector<ScalarField> fields(2, {Eigen::VectorXd(5000), Eigen::VectorXd::Ones(5000)});
  for (ScalarField& field : fields) {
    for (double& value : field.values) value = random.uniform(0, 1);
  }
  const auto on = [&](int threads, int seed) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return codebook_of({fields}, {.words = 40, .seed = seed}).words; });
  };
  const Eigen::MatrixXf one = on(1, 1);
  const Eigen::MatrixXf four = on(4, 1);
  EXPECT_EQ(std::memcmp(one.data(), four.data(), sizeof(float) * static_cast<std::size_t>(one.size())), 0);
  EXPECT_NE(one, on(1, 2));
}

TEST(Codebook, HasNoMoreWordsThanDistinctSamples) {
  const std::vector<ScalarField> fields(2, {Eigen::VectorXd::Ones(100), Eigen::VectorXd::Ones(100)});
  const Codebook found = codebook_of({fields}, {.words = 5});
  EXPECT_EQ(found.words.rows(), 1);
  EXPECT_EQ(bag_of_features(fields, found, {.words = 5}), (Eigen::VectorXf::Unit(5, 0)));
}

TEST(Codebook, DoesNotDependOnTheUnitsOfStandardisedFields) {
  const std::vector<ScalarField> fields = clustered(corners, 1);
  std::vector<ScalarField> other = fields;
  other[1].values *= 1024;
  const BagOfFeaturesOptions options = {.words = 3, .standardise = true};
  EXPECT_EQ(bag_of_features(fields, codebook_of({fields}, options), options),
            bag_of_features(other, codebook_of({other}, options), options));
}

TEST(BagOfFeatures, SumsTheWeightOfSamplesNearestToEachWord) {
  std::vector<ScalarField> fields = clustered(corners, 1);
  for (ScalarField& field : fields) field.weights.head(50).setConstant(3);
  const BagOfFeaturesOptions options = {.words = 3};
  Eigen::VectorXf found = bag_of_features(fields, codebook_of({fields}, options), options);
  std::ranges::sort(found);
  EXPECT_EQ(found, (Eigen::Vector3f{0.2F, 0.2F, 0.6F}));
}

TEST(BagOfFeatures, SoftAssignmentSplitsSamplesBetweenWords) {
  const Codebook two = {Eigen::RowVector2f::Ones(), Eigen::Matrix2f{{0, 0}, {1, 0}}};
  const auto at = [](double x) {
    return std::vector<ScalarField>{{Eigen::VectorXd::Constant(1, x), Eigen::VectorXd::Ones(1)},
                                    {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1)}};
  };
  const BagOfFeaturesOptions options = {.words = 2, .soft = true};
  const Eigen::VectorXf between = bag_of_features(at(0.5), two, options);
  EXPECT_NEAR(between[0], 0.5, 1e-6);
  // At a word: 1 to exp(-1/2), as the words are one width apart.
  EXPECT_NEAR(bag_of_features(at(0), two, options)[0], 1 / (1 + std::exp(-0.5)), 1e-6);
  // Far from both, weights do not vanish.
  EXPECT_NEAR(bag_of_features(at(1e6), two, options).sum(), 1, 1e-6);
}

TEST(BagOfFeatures, IgnoresSamplesWithMissingValues) {
  std::vector<ScalarField> fields = clustered(corners, 1);
  const BagOfFeaturesOptions options = {.words = 3};
  const Codebook words = codebook_of({fields}, options);
  fields[1].values.head(50).setConstant(std::numeric_limits<double>::quiet_NaN());
  Eigen::VectorXf found = bag_of_features(fields, words, options);
  std::ranges::sort(found);
  EXPECT_EQ(found, (Eigen::Vector3f{0, 0.5F, 0.5F}));
}

TEST(BagOfFeatures, RegisteredDescriptorEqualsTheFunctionsCalledDirectly) {
  const std::vector<ScalarField> fields = clustered(corners, 1);
  const Shape none;
  const std::vector<DescriptorInput> inputs = {{none, fields}};
  const Descriptor& bag = descriptors().at("bag_of_features");
  DescriptorSettings settings = default_settings(bag, 2);
  settings.values.set("words", std::int64_t{3});
  const BagOfFeaturesOptions options = {.words = 3};
  EXPECT_EQ(bag.describe(inputs[0], bag.learn(inputs, settings), settings),
            bag_of_features(fields, codebook_of({fields}, options), options));
}

TEST(BagOfFeatures, RejectsZeroWordsMissingFieldsAndZeroWeights) {
  const std::vector<ScalarField> fields = clustered(corners, 1);
  const BagOfFeaturesOptions options = {.words = 3};
  const Codebook words = codebook_of({fields}, options);
  EXPECT_THROW(codebook_of({fields}, {.words = 0}), InputError);
  EXPECT_THROW(codebook_of({}, options), ArgumentError);
  EXPECT_THROW(codebook_of({fields, {fields[0]}}, options), ArgumentError);
  EXPECT_THROW(bag_of_features(std::span(fields).first(1), words, options), ArgumentError);
  std::vector<ScalarField> nothing = fields;
  nothing[0].weights.setZero();
  EXPECT_THROW(bag_of_features(nothing, words, options), ArgumentError);
  EXPECT_THROW(codebook_of({nothing}, options), ArgumentError);
}

TEST(Codebook, UsesSamplesAtMidpointsOfEqualWeightFractions) {
  // Of four samples of equal weight the second and the fourth begin beyond a quarter and three quarters of it.
  const std::vector<ScalarField> fields = {{Eigen::Vector4d(10, 20, 30, 40), Eigen::Vector4d::Ones()}};
  Eigen::MatrixXf words = codebook_of({fields}, {.words = 2, .standardise = false, .samples_per_shape = 2}).words;
  std::ranges::sort(words.reshaped());
  EXPECT_EQ(words, Eigen::Vector2f(20, 40));
}

TEST(Codebook, ScalesOfFieldsAreStandardDeviations) {
  const std::vector<ScalarField> fields = {{Eigen::Vector2d(0, 6), Eigen::Vector2d::Ones()}};
  const Codebook found = codebook_of({fields}, {.words = 2, .standardise = true, .samples_per_shape = 2});
  EXPECT_FLOAT_EQ(found.scales[0], 3);
}

}  // namespace
}  // namespace shapegauge
