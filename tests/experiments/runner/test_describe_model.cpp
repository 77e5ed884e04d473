#include <gmock/gmock.h>

#include "shapegauge/experiments/configuration/fields.h"
#include "shapegauge/experiments/runner/describe_model.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

SignatureConfiguration signature(const nlohmann::json& field, HistogramRange range) {
  return {.name = "x",
          .field = make_field(field),
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

}  // namespace

}  // namespace shapegauge
