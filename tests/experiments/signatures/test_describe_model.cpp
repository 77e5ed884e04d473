// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/signatures/describe_model.h"

namespace shapegauge {

namespace {

SignatureConfiguration signature(const nlohmann::json& field, HistogramRange range) {
  return {.name = "x",
          .field = read_field(field),
          .histogram = {.options = {}, .range = range, .fixed = {}},
          .descriptor = {},
          .derived = {},
          .parts = {}};
}

TEST(DistinctFields, MergeFieldsWhoseSettingsAreEqualAfterFillingInDefaults) {
  const std::vector<SignatureConfiguration> signatures{
      signature({{"type", "cone_sdf"}}, HistogramRange::fixed),
      signature({{"type", "cone_sdf"}, {"rays", 26}}, HistogramRange::per_shape),
      SignatureConfiguration{
          .name = "both", .field = std::nullopt, .histogram = {}, .descriptor = {}, .derived = {}, .parts = {0, 1}},
      signature({{"type", "cone_sdf"}, {"rays", 25}, {"engine", "embree"}}, HistogramRange::dataset)};
  const std::vector<Field> fields = distinct_fields(signatures);
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(index_of(fields, *signatures[3].field), 0U);
  EXPECT_EQ(index_of(fields, *signatures[1].field), 1U);
  EXPECT_EQ(first_histogram_of(fields[0], signatures), 0U);
  EXPECT_EQ(first_histogram_of(read_field({{"type", "cone_sdf"}, {"rays", 27}}), signatures), std::nullopt);
}

TEST(DescribeField, StoresFieldValuesOnlyIfTheHistogramRangeIsOverTheDataSet) {
  const StoredField field{
      .range = {.low = 0.25, .high = 1}, .outcomes = {}, .offset = {}, .values = Eigen::Vector3d(0.25, 0.5, 1)};
  for (const HistogramRange range : {HistogramRange::per_shape, HistogramRange::dataset}) {
    const std::vector<SignatureConfiguration> signatures{signature({{"type", "cone_sdf"}}, range)};
    std::vector<FeatureDescription> features(1);
    const FieldDescription description =
        describe_field(field, Eigen::Vector3d(1, 1, 2), *signatures[0].field, signatures, features);
    const bool waits = range == HistogramRange::dataset;
    EXPECT_EQ(description.values.size(), waits ? 3 : 0);  // those of thousands of shapes would exhaust memory
    EXPECT_EQ(features[0].features.size(), waits ? 0 : 80);
    EXPECT_EQ(description.range.high, 1);
  }
}

}  // namespace

}  // namespace shapegauge
