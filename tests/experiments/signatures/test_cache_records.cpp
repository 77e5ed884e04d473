#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/experiments/signatures/cache_records.h"
#include "shapegauge/experiments/signatures/shape_reports.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

const ModelSource source{.sha256 = "abc", .file = "data/T1.off", .id = "1", .index = 1};

std::string key_of_shape(const ModelSource& of, const Configuration& configuration) {
  return shape_key(of, configuration.preparation, configuration.perturbations, configuration.seed);
}

std::vector<Perturbation> noise(double amplitude) {
  return make_perturbations({{{"type", "vertex_noise"}, {"amplitude", amplitude}}});
}

TEST(CacheKeys, AShapeIsItsBytesAndItsFormatWhereverItIs) {
  const Configuration plain;
  const std::string key = key_of_shape(source, plain);
  EXPECT_EQ(key.size(), 64U);
  EXPECT_EQ(key, key_of_shape({.sha256 = "abc", .file = "elsewhere/X.OFF", .id = "7", .index = 3}, plain));
  EXPECT_NE(key, key_of_shape({.sha256 = "abd", .file = "data/T1.off", .id = "1", .index = 1}, plain));
  EXPECT_NE(key, key_of_shape({.sha256 = "abc", .file = "data/T1.txt", .id = "1", .index = 1}, plain));
}

TEST(CacheKeys, AShapeDependsOnThePreparation) {
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

TEST(CacheKeys, APerturbedShapeDependsOnTheSeedAndTheModelToo) {
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

TEST(CacheKeys, AFieldDependsOnItsSettingsAndItsVersion) {
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

TEST(CacheKeys, AComparedShapeDependsOnItsHistogramsTheReferenceTheVersionAndTheThreads) {
  const std::set<std::string> keys{comparison_key({"a", "b"}, "c", 1, 2), comparison_key({"b", "a"}, "c", 1, 2),
                                   comparison_key({"a", "b"}, "", 1, 2), comparison_key({"a", "b"}, "c", 2, 2),
                                   comparison_key({"a", "b"}, "c", 1, 1)};
  EXPECT_EQ(keys.size(), 5U);
}

TEST(CacheKeys, APictureDependsOnItsFieldAndOnHowItIsDrawn) {
  std::set<std::string> keys{picture_key("field", {}), picture_key("other field", {})};
  keys.insert(picture_key("field", {.range = {.low = 0, .high = 0.5}}));
  keys.insert(picture_key("field", {.width = 64}));
  keys.insert(picture_key("field", {.height = 64}));
  EXPECT_EQ(keys.size(), 5U);
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

namespace {

using nlohmann::json;

/// The record after writing and reading.
json stored(const json& record) { return json::from_cbor(json::to_cbor(record)); }

template <typename Vector>
void expect_same_bits(const Vector& a, const Vector& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(typename Vector::Scalar)), 0);
}

FieldDescription facts() {
  FieldDescription facts;
  facts.range = {.low = 0.1, .high = 1.0 / 3};
  facts.outcomes = {{"total", 12}, {"missing", 1}};
  facts.offset = 0.012345678901234567;
  facts.seconds = 1.5;
  return facts;
}

void expect_facts(const FieldDescription& found) {
  EXPECT_EQ(found.range.low, 0.1);
  EXPECT_EQ(found.range.high, 1.0 / 3);
  EXPECT_EQ(found.outcomes, facts().outcomes);
  EXPECT_EQ(found.offset, facts().offset);
  EXPECT_EQ(found.seconds, 1.5);
}

TEST(CacheRecords, AllThatIsKnownOfAShape) {
  ModelDescription model;
  // Holes, a second part and an unused vertex: all diagnostics but those of clouds and noise are non-zero.
  Shape shape = test::joined({test::box({1, 2, 0.3}, 3), test::sphere(1, 1)});
  shape.triangles.conservativeResize(shape.triangles.rows() - 2, Eigen::NoChange);
  model.diagnostics = diagnose(shape);
  model.diagnostics.gap_size = 0.25;
  model.diagnostics.closable_gap = 0.0625;
  model.diagnostics.outliers = 3;
  model.diagnostics.point_spacing = 0.125;
  model.diagnostics.noise_deviation = 1.0 / 7;
  model.diagnostics.noisy = true;
  model.chosen = {2, 0};
  model.remarks = {"decimated to 9 faces"};
  model.area = 1.0 / 3;
  model.noise = 0.2;
  model.pass_band = 0.1;
  const ModelDescription found = read_shape_record(stored(shape_record(model)));
  EXPECT_EQ(diagnostics_json(found.diagnostics), diagnostics_json(model.diagnostics));
  EXPECT_EQ(found.diagnostics.closable_gap, model.diagnostics.closable_gap);
  EXPECT_EQ(found.diagnostics.noise_deviation, model.diagnostics.noise_deviation);
  EXPECT_EQ(found.chosen, model.chosen);
  EXPECT_EQ(found.remarks, model.remarks);
  EXPECT_EQ(found.area, model.area);
  EXPECT_EQ(found.noise, model.noise);
  EXPECT_EQ(found.pass_band, model.pass_band);
}

TEST(CacheRecords, AFieldWithItsValues) {
  const double infinity = std::numeric_limits<double>::infinity();
  const CachedField field{.facts = facts(),
                          .values = Eigen::Vector4d(0.1, -0.0, infinity, std::numeric_limits<double>::quiet_NaN())};
  const CachedField found = read_field_record(stored(field_record(field)));
  expect_facts(found.facts);
  expect_same_bits(found.values, field.values);
}

TEST(CacheRecords, AFieldThatChoseNoOffset) {
  CachedField field{.facts = facts(), .values = {}};
  field.facts.offset = std::nullopt;
  const CachedField found = read_field_record(stored(field_record(field)));
  EXPECT_EQ(found.facts.offset, std::nullopt);
  EXPECT_EQ(found.values.size(), 0);
}

TEST(CacheRecords, AHistogram) {
  const CachedHistogram histogram{.facts = facts(), .bins = Eigen::Vector3f(0.1F, 0.2F, 0.7F)};
  const CachedHistogram found = read_histogram_record(stored(histogram_record(histogram)));
  expect_facts(found.facts);
  expect_same_bits(found.bins, histogram.bins);
}

TEST(CacheRecords, APicture) {
  const std::string bytes("\x89PNG\0\xff", 6);
  EXPECT_EQ(read_picture(picture_record(bytes)), bytes);
}

TEST(CacheRecords, ADistanceMatrix) {
  DistanceMatrix distances(2, 2);
  distances << 0, 1.0 / 3, 1.0 / 3, 0;
  EXPECT_EQ(read_distances(stored(distances_record(distances))), distances);
}

TEST(CacheRecords, AnotherFormIsAnError) {
  for (const json& other : {json(), json(1), json::object(), json{{"values", 3}, {"facts", json::object()}}}) {
    EXPECT_THROW(read_field_record(other), json::exception);
    EXPECT_THROW(read_histogram_record(other), json::exception);
    EXPECT_THROW(read_shape_record(other), json::exception);
    EXPECT_THROW(read_distances(other), json::exception);
    EXPECT_THROW(read_numbers(other), json::exception);
  }
}

}  // namespace

}  // namespace shapegauge
