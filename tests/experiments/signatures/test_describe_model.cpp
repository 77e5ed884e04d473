#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/signatures/describe_model.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

SignatureConfiguration signature(const nlohmann::json& field, HistogramRange range) {
  return {.name = "x",
          .field = read_field(field),
          .histogram = {.options = {}, .range = range, .fixed = {}},
          .descriptor = {},
          .derived = {},
          .parts = {}};
}

TEST(PlanFields, EqualSettingsAreOneFieldWhetherWrittenOutOrNot) {
  const std::vector<SignatureConfiguration> signatures{
      signature({{"type", "cone_sdf"}}, HistogramRange::fixed),
      signature({{"type", "cone_sdf"}, {"rays", 26}}, HistogramRange::per_shape),
      SignatureConfiguration{
          .name = "both", .field = std::nullopt, .histogram = {}, .descriptor = {}, .derived = {}, .parts = {0, 1}},
      signature({{"type", "cone_sdf"}, {"rays", 25}, {"engine", "embree"}}, HistogramRange::dataset)};
  const std::vector<PlannedField> plan = plan_fields(signatures);
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_THAT(plan[0].signatures, ElementsAre(0, 3));
  EXPECT_THAT(plan[1].signatures, ElementsAre(1));
  EXPECT_TRUE(plan[0].keep_values);
  EXPECT_FALSE(plan[1].keep_values);
}

TEST(DescribeField, KeepsValuesOnlyForARangeOverAllShapes) {
  const StoredField field{
      .range = {.low = 0.25, .high = 1}, .outcomes = {}, .offset = {}, .values = Eigen::Vector3d(0.25, 0.5, 1)};
  for (const HistogramRange range : {HistogramRange::per_shape, HistogramRange::dataset}) {
    const std::vector<SignatureConfiguration> signatures{signature({{"type", "cone_sdf"}}, range)};
    const std::vector<PlannedField> plan = plan_fields(signatures);
    std::vector<Eigen::VectorXf> histograms(1);
    const FieldDescription kept = describe_field(field, Eigen::Vector3d(1, 1, 2), plan[0], signatures, histograms);
    const bool waits = range == HistogramRange::dataset;
    EXPECT_EQ(kept.values.size(), waits ? 3 : 0);  // those of thousands of shapes would exhaust memory
    EXPECT_EQ(histograms[0].size(), waits ? 0 : 80);
    EXPECT_EQ(kept.range.high, 1);
  }
}

}  // namespace

}  // namespace shapegauge
