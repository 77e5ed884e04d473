#include <cstring>
#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/experiments/cache/cache_records.h"
#include "shapegauge/experiments/results/diagnostics_json.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

using nlohmann::json;

/// As it would come back from a file.
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
  // Holes, a second part and a vertex too many: every diagnostic but those of clouds and noise is other than zero.
  Shape shape = test_shapes::joined({test_shapes::box({1, 2, 0.3}, 3), test_shapes::sphere(1, 1)});
  shape.triangles.conservativeResize(shape.triangles.rows() - 2, Eigen::NoChange);
  model.diagnostics = diagnose(shape);
  model.diagnostics.point_spacing = 0.125;
  model.diagnostics.noise_deviation = 1.0 / 7;
  model.diagnostics.noisy = true;
  model.chosen = {2, 0};
  model.area = 1.0 / 3;
  model.noise = 0.2;
  model.pass_band = 0.1;
  const ModelDescription found = read_shape_record(stored(shape_record(model)));
  EXPECT_EQ(diagnostics_json(found.diagnostics), diagnostics_json(model.diagnostics));
  EXPECT_EQ(found.diagnostics.noise_deviation, model.diagnostics.noise_deviation);
  EXPECT_EQ(found.chosen, model.chosen);
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
