// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/experiments/signatures/cache_keys.h"

namespace shapegauge {

namespace {

const ModelSource source{.sha256 = "abc", .file = "data/T1.off", .id = "1", .index = 1};

std::string key_of_shape(const ModelSource& of, const Configuration& configuration) {
  return shape_key(of, configuration.preparation, configuration.perturbations, configuration.seed);
}

std::vector<Perturbation> noise(double amplitude) {
  return make_perturbations({{{"type", "vertex_noise"}, {"amplitude", amplitude}}});
}

TEST(CacheKeys, OfAShapeDependOnItsBytesAndFormatButNotOnItsPath) {
  const Configuration plain;
  const std::string key = key_of_shape(source, plain);
  EXPECT_EQ(key.size(), 64U);
  EXPECT_EQ(key, key_of_shape({.sha256 = "abc", .file = "elsewhere/X.OFF", .id = "7", .index = 3}, plain));
  EXPECT_NE(key, key_of_shape({.sha256 = "abd", .file = "data/T1.off", .id = "1", .index = 1}, plain));
  EXPECT_NE(key, key_of_shape({.sha256 = "abc", .file = "data/T1.txt", .id = "1", .index = 1}, plain));
}

TEST(CacheKeys, OfAShapeDependOnItsPreparation) {
  std::set<std::string> keys;
  for (const bool denoise : {false, true}) {
    for (const ScaleEstimate scale : {ScaleEstimate::area, ScaleEstimate::tube_area}) {
      Configuration configuration;
      configuration.preparation = {.denoise = denoise, .scale = scale};
      keys.insert(key_of_shape(source, configuration));
    }
  }
  EXPECT_EQ(keys.size(), 4U);
}

TEST(CacheKeys, OfAPerturbedShapeDependOnTheSeedAndTheModel) {
  Configuration configuration;
  configuration.seed = 2;
  EXPECT_EQ(key_of_shape(source, configuration), key_of_shape(source, Configuration{})) << "nothing is drawn";
  configuration.perturbations = noise(0.01);
  std::set<std::string> keys{key_of_shape(source, Configuration{}), key_of_shape(source, configuration)};
  keys.insert(key_of_shape({.sha256 = "abc", .file = "data/T1.off", .id = "2", .index = 1}, configuration));
  keys.insert(key_of_shape({.sha256 = "abc", .file = "data/T1.off", .id = "1", .index = 2}, configuration));
  configuration.seed = 3;
  keys.insert(key_of_shape(source, configuration));
  configuration.perturbations = noise(0.02);
  keys.insert(key_of_shape(source, configuration));
  EXPECT_EQ(keys.size(), 6U);
}

TEST(CacheKeys, OfAFieldDependOnItsSettingsAndVersion) {
  std::set<std::string> keys;
  for (const nlohmann::json& settings :
       {nlohmann::json{{"type", "offset_sdf"}, {"offset", 0.01}},
        nlohmann::json{{"type", "offset_sdf"}, {"offset", 0.02}},
        nlohmann::json{{"type", "offset_sdf"}, {"offset", "auto"}},
        nlohmann::json{{"type", "offset_sdf"}, {"offset", 0.01}, {"at", "vertices"}},
        nlohmann::json{{"type", "cone_sdf"}}, nlohmann::json{{"type", "cone_sdf"}, {"rays", 9}}}) {
    Field field = read_field(settings);
    EXPECT_FALSE(field.versions.empty()) << settings;
    keys.insert(field_key("shape", field));
    keys.insert(field_key("other shape", field));
    for (auto& [algorithm, version] : field.versions) ++version;
    keys.insert(field_key("shape", field));
  }
  EXPECT_EQ(keys.size(), 18U);
}

TEST(CacheKeys, OfAComparedShapeDependOnEveryInput) {
  const std::vector<HistogramConfiguration> histograms{
      {.options = {.bins = 80}, .range = HistogramRange::per_shape, .fixed = {}},
      {.options = {.bins = 81}, .range = HistogramRange::per_shape, .fixed = {}},
      {.options = {.bins = 80, .smoothing_bins = 1}, .range = HistogramRange::per_shape, .fixed = {}},
      {.options = {.bins = 80}, .range = HistogramRange::fixed, .fixed = {.low = 0, .high = 0.6}},
      {.options = {.bins = 80}, .range = HistogramRange::fixed, .fixed = {.low = 0.1, .high = 0.6}},
      {.options = {.bins = 80}, .range = HistogramRange::fixed, .fixed = {.low = 0, .high = 0.7}}};
  std::set<std::string> keys;
  for (const HistogramConfiguration& histogram : histograms) {
    keys.insert(comparison_key({"a", "b"}, {histogram}, "c", 1, 2));
    keys.insert(comparison_key({"b", "a"}, {histogram}, "c", 1, 2));
    keys.insert(comparison_key({"a", "b"}, {histogram}, "", 1, 2));
    keys.insert(comparison_key({"a", "b"}, {histogram}, "c", 2, 2));
    keys.insert(comparison_key({"a", "b"}, {histogram}, "c", 1, 1));
  }
  EXPECT_EQ(keys.size(), 30U);
}

TEST(CacheKeys, OfAPictureDependOnItsFieldAndOptions) {
  const Eigen::Vector3d up(0, 0, 1);
  std::set<std::string> keys{picture_key("field", {}, up), picture_key("other field", {}, up)};
  keys.insert(picture_key("field", {.range = {.low = 0, .high = 0.5}}, up));
  keys.insert(picture_key("field", {.width = 64}, up));
  keys.insert(picture_key("field", {.height = 64}, up));
  keys.insert(picture_key("field", {}, -up));
  EXPECT_EQ(keys.size(), 6U);
  keys = {view_key({"field"}, {}), view_key({"field"}, {.faces = 9}), view_key({"field"}, {.up = -up})};
  EXPECT_EQ(keys.size(), 3U);
}

TEST(CacheKeys, OfDistancesDependOnTheSignaturesAndTheirSize) {
  Signatures signatures{{0, 1, 2}, {3, 4, 5}};
  std::set<std::string> keys{distances_key(signatures, "l1"), distances_key(signatures, "l2")};
  const Signatures other_size{{0, 1}, {2, 3}, {4, 5}};
  keys.insert(distances_key(other_size, "l1"));
  signatures(1, 2) = std::nextafter(5.0F, 6.0F);
  keys.insert(distances_key(signatures, "l1"));
  EXPECT_EQ(keys.size(), 4U);
}

}  // namespace

}  // namespace shapegauge
