// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/descriptor_choice.h"
#include "shapegauge/experiments/signatures/describe_learnt.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/distances.h"
#include "tests/support/test_files.h"

namespace shapegauge {
namespace {

std::atomic<int> lessons_learnt = 0;

/// Learns the number of shapes and the mean of their first values.
LearntFeatures learn_mean(std::span<const DescriptorInput> inputs, const DescriptorSettings& /*settings*/) {
  ++lessons_learnt;
  if (inputs.empty()) throw InputError("no shapes to learn from");
  double sum = 0;
  for (const DescriptorInput& input : inputs) sum += input.fields[0].values[0];
  const auto count = static_cast<double>(inputs.size());
  return LearntFeatures{{static_cast<float>(count), static_cast<float>(sum / count)}};
}

/// Describes a shape by its first value less the mean. Cannot describe values above 100.
Eigen::VectorXf describe_by_mean(const DescriptorInput& input, const LearntFeatures& learnt,
                                 const DescriptorSettings& /*settings*/) {
  const double value = input.fields[0].values[0];
  if (value > 100) throw InputError("the value is too large");
  return Eigen::VectorXf::Constant(1, static_cast<float>(value) - learnt(0, 1));
}

/// Configuration with two signatures: that descriptor and one that does not learn.
Configuration mean_configuration(OnError on_error = OnError::stop) {
  if (descriptors().find("test_mean") == nullptr) {
    descriptors().add({.name = "test_mean",
                       .description = "Difference from the mean.",
                       .parameters = {},
                       .min_fields = 1,
                       .max_fields = 1,
                       .describe = describe_by_mean,
                       .distance = l2_distance,
                       .learn = learn_mean});
  }
  Configuration configuration;
  configuration.on_error = on_error;
  configuration.signatures.resize(2);
  configuration.signatures[0].name = "plain";
  configuration.signatures[0].descriptor = make_descriptor({{"type", "d2"}});
  configuration.signatures[1].name = "mean";
  configuration.signatures[1].descriptor =
      make_descriptor({{"type", "test_mean"}, {"fields", {{{"type", "cone_sdf"}}}}});
  return configuration;
}

/// Models whose fields have these first values, by index. Without a field for a value of -1.
DescribedModels models_of(const std::map<std::size_t, float>& values) {
  DescribedModels models;
  for (const auto& [index, value] : values) {
    ModelDescription& model = models[index];
    model.shape_key = "shape " + std::to_string(index);
    model.fields.resize(1);
    model.fields[0].values = Eigen::VectorXf::Constant(3, value);
    model.fields[0].weights = Eigen::VectorXf::Ones(3);
    if (value == -1) model.fields[0].error = "no field";
    model.features.resize(2);
    model.features[0].features = Eigen::VectorXf::Constant(1, 77);
  }
  return models;
}

struct Outcome {
  std::vector<ModelFailure> failures;
  std::vector<LearntFeatures> learnt;
};

Outcome described(DescribedModels& models, const Configuration& configuration, Cache& cache) {
  Outcome outcome;
  outcome.failures = describe_learnt(models, configuration, distinct_fields(configuration.signatures),
                                     {.control = {}, .cache = cache}, outcome.learnt);
  return outcome;
}

Outcome described(DescribedModels& models, const Configuration& configuration) {
  Cache none;
  return described(models, configuration, none);
}

/// The feature of a model; -1 if it has none.
float feature_of(const DescribedModels& models, std::size_t index) {
  const Eigen::VectorXf& features = models.at(index).features[1].features;
  return features.size() > 0 ? features[0] : -1;
}

const std::map<std::size_t, float> five_values{{0, 1}, {2, 2}, {3, 4}, {7, 8}, {9, 10}};

TEST(DescribeWithCodebook, LearnsFromAllModelsAndDescribesEach) {
  DescribedModels models = models_of(five_values);
  const Outcome outcome = described(models, mean_configuration());
  EXPECT_TRUE(outcome.failures.empty());
  ASSERT_EQ(outcome.learnt.size(), 2U);
  EXPECT_EQ(outcome.learnt[0].size(), 0) << "a descriptor that does not learn";
  EXPECT_EQ(outcome.learnt[1], (LearntFeatures{{5, 5}}));
  for (const auto& [index, value] : five_values) EXPECT_EQ(feature_of(models, index), value - 5) << index;
  EXPECT_EQ(models.at(3).features[0].features[0], 77) << "others stay";
}

TEST(DescribeWithCodebook, IgnoresModelsWithoutTheField) {
  DescribedModels models = models_of({{0, 1}, {1, -1}, {2, 3}});
  const Outcome outcome = described(models, mean_configuration(OnError::skip));
  EXPECT_EQ(outcome.learnt[1], (LearntFeatures{{2, 2}}));
  EXPECT_EQ(feature_of(models, 0), -1);
  EXPECT_EQ(models.at(1).features[1].features.size(), 0);
  EXPECT_EQ(feature_of(models, 2), 1);
}

TEST(DescribeWithCodebook, OmitsUndescribableModelsIfErrorsAreSkipped) {
  const std::map<std::size_t, float> values{{0, 1}, {1, 500}, {2, 3}, {5, 200}};
  DescribedModels models = models_of(values);
  const Outcome outcome = described(models, mean_configuration(OnError::skip));
  EXPECT_TRUE(outcome.failures.empty());
  EXPECT_EQ(outcome.learnt[1], (LearntFeatures{{2, 2}}));
  for (const auto& [index, value] : values) {
    EXPECT_EQ(models.at(index).features[1].error.empty(), value < 100) << index;
    EXPECT_EQ(feature_of(models, index), value < 100 ? value - 2 : -1) << index;
  }
}

TEST(DescribeWithCodebook, StopsAtTheFirstModelThatCannotBeDescribed) {
  DescribedModels models = models_of({{0, 1}, {1, 3}, {2, 500}});
  const Outcome outcome = described(models, mean_configuration(OnError::stop));
  ASSERT_EQ(outcome.failures.size(), 1U);
  EXPECT_EQ(outcome.failures[0].model, 2U);
  EXPECT_THAT(outcome.failures[0].message, testing::HasSubstr("too large"));
}

TEST(DescribeWithCodebook, RejectsAnEmptyCollection) {
  DescribedModels none;
  EXPECT_THROW(described(none, mean_configuration()), InputError);
  DescribedModels without_field = models_of({{0, -1}});
  EXPECT_THROW(described(without_field, mean_configuration(OnError::skip)), InputError);
  DescribedModels all_fail = models_of({{0, 500}});
  EXPECT_THROW(described(all_fail, mean_configuration(OnError::skip)), InputError);
}

TEST(DescribeWithCodebook, ReusesCachedResultsOnlyForAnUnchangedCollection) {
  const test::TemporaryFolder folder;
  const auto run = [&](const std::map<std::size_t, float>& values) {
    Cache cache(folder.path() / "cache");
    DescribedModels models = models_of(values);
    const int before = lessons_learnt;
    const Outcome outcome = described(models, mean_configuration(), cache);
    EXPECT_EQ(outcome.learnt[1](0, 0), static_cast<float>(values.size()));
    for (const auto& [index, value] : values) EXPECT_EQ(feature_of(models, index), value - outcome.learnt[1](0, 1));
    const CacheUse features = cache.report().uses.at(static_cast<std::size_t>(EntryKind::features));
    return std::pair(lessons_learnt - before, features.hits);
  };
  EXPECT_EQ(run(five_values), std::pair(1, std::size_t{0}));
  EXPECT_EQ(run(five_values), std::pair(0, std::size_t{5}));
  std::map<std::size_t, float> fewer = five_values;
  fewer.erase(7);
  EXPECT_EQ(run(fewer), std::pair(1, std::size_t{0})) << "all features depend on what is learnt";
}

TEST(DescribeWithCodebook, StopsWhenInterrupted) {
  DescribedModels models = models_of(five_values);
  const Configuration configuration = mean_configuration();
  Cache none;
  std::vector<LearntFeatures> learnt;
  const RunControl control{.interrupted = [] { return true; }};
  EXPECT_THROW(describe_learnt(models, configuration, distinct_fields(configuration.signatures),
                               {.control = control, .cache = none}, learnt),
               Interrupted);
}

}  // namespace
}  // namespace shapegauge
