#include <cmath>
#include <gmock/gmock.h>
#include <set>

#include "shapegauge/experiments/cache/cache_keys.h"
#include "shapegauge/experiments/fields/field_registry.h"
#include "shapegauge/experiments/perturbations/perturbation_registry.h"

namespace shapegauge {
namespace {

const ModelSource source{.sha256 = "abc", .file = "data/T1.off", .id = "1", .index = 1};

std::vector<Perturbation> noise(double amplitude) {
  return make_perturbations({{{"type", "vertex_noise"}, {"amplitude", amplitude}}});
}

TEST(CacheKeys, AShapeIsItsBytesAndItsFormatWhereverItIs) {
  const Configuration plain;
  const std::string key = shape_key(source, plain);
  EXPECT_EQ(key.size(), 64U);
  EXPECT_EQ(key, shape_key({.sha256 = "abc", .file = "elsewhere/X.OFF", .id = "7", .index = 3}, plain));
  EXPECT_NE(key, shape_key({.sha256 = "abd", .file = "data/T1.off", .id = "1", .index = 1}, plain));
  EXPECT_NE(key, shape_key({.sha256 = "abc", .file = "data/T1.txt", .id = "1", .index = 1}, plain));
}

TEST(CacheKeys, AShapeDependsOnThePreparation) {
  std::set<std::string> keys;
  for (const bool denoise : {false, true}) {
    for (const ScaleEstimate scale : {ScaleEstimate::area, ScaleEstimate::tube_area}) {
      Configuration configuration;
      configuration.preparation = {.denoise = denoise, .scale = scale};
      keys.insert(shape_key(source, configuration));
    }
  }
  EXPECT_EQ(keys.size(), 4U);
}

TEST(CacheKeys, APerturbedShapeDependsOnTheSeedAndTheModelToo) {
  Configuration configuration;
  configuration.seed = 2;
  EXPECT_EQ(shape_key(source, configuration), shape_key(source, Configuration{})) << "nothing is drawn";
  configuration.perturbations = noise(0.01);
  std::set<std::string> keys{shape_key(source, Configuration{}), shape_key(source, configuration)};
  keys.insert(shape_key({.sha256 = "abc", .file = "data/T1.off", .id = "2", .index = 1}, configuration));
  keys.insert(shape_key({.sha256 = "abc", .file = "data/T1.off", .id = "1", .index = 2}, configuration));
  configuration.seed = 3;
  keys.insert(shape_key(source, configuration));
  configuration.perturbations = noise(0.02);
  keys.insert(shape_key(source, configuration));
  EXPECT_EQ(keys.size(), 6U);
}

TEST(CacheKeys, AFieldDependsOnItsSettingsAndItsVersion) {
  std::set<std::string> keys;
  for (const nlohmann::json& settings :
       {nlohmann::json{{"type", "offset_sdf"}, {"offset", 0.01}},
        nlohmann::json{{"type", "offset_sdf"}, {"offset", 0.02}},
        nlohmann::json{{"type", "offset_sdf"}, {"offset", "auto"}},
        nlohmann::json{{"type", "offset_sdf"}, {"offset", 0.01}, {"at", "vertices"}},
        nlohmann::json{{"type", "cone_sdf"}}, nlohmann::json{{"type", "cone_sdf"}, {"rays", 9}}}) {
    Field field = make_field(settings);
    EXPECT_FALSE(field.versions.empty()) << settings;
    keys.insert(field_key("shape", field));
    keys.insert(field_key("other shape", field));
    for (auto& version : field.versions) version = version.get<int>() + 1;
    keys.insert(field_key("shape", field));
  }
  EXPECT_EQ(keys.size(), 18U);
}

TEST(CacheKeys, AHistogramDependsOnItsSettings) {
  const std::vector<HistogramConfiguration> histograms{
      {.options = {.bins = 80}, .range = HistogramRange::per_shape, .fixed = {}},
      {.options = {.bins = 81}, .range = HistogramRange::per_shape, .fixed = {}},
      {.options = {.bins = 80, .smoothing_bins = 1}, .range = HistogramRange::per_shape, .fixed = {}},
      {.options = {.bins = 80}, .range = HistogramRange::fixed, .fixed = {.low = 0, .high = 0.6}},
      {.options = {.bins = 80}, .range = HistogramRange::fixed, .fixed = {.low = 0.1, .high = 0.6}},
      {.options = {.bins = 80}, .range = HistogramRange::fixed, .fixed = {.low = 0, .high = 0.7}}};
  std::set<std::string> keys;
  for (const HistogramConfiguration& histogram : histograms) {
    keys.insert(histogram_key("field", histogram));
    keys.insert(histogram_key("other field", histogram));
  }
  EXPECT_EQ(keys.size(), 12U);
}

TEST(CacheKeys, DistancesDependOnTheSignaturesAndTheirSize) {
  Signatures signatures(2, 3);
  signatures << 0, 1, 2, 3, 4, 5;
  std::set<std::string> keys{distances_key(signatures, "l1"), distances_key(signatures, "l2")};
  Signatures other_size(3, 2);
  other_size << 0, 1, 2, 3, 4, 5;
  keys.insert(distances_key(other_size, "l1"));
  signatures(1, 2) = std::nextafter(5.0F, 6.0F);
  keys.insert(distances_key(signatures, "l1"));
  EXPECT_EQ(keys.size(), 4U);
}

}  // namespace
}  // namespace shapegauge
