#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

TEST(ReadField, TakesSettingsAndFillsInDefaults) {
  const Field field = read_field({{"type", "offset_sdf"}, {"offset", 0.03}, {"at", "vertices"}});
  EXPECT_EQ(field.settings.samples.site, SampleSite::vertices);
  EXPECT_EQ(field.settings.values.number("offset"), 0.03);
  EXPECT_EQ(to_json(field.settings),
            (Json{{"type", "offset_sdf"}, {"offset", 0.03}, {"accuracy", "standard"}, {"at", "vertices"}}));
  EXPECT_EQ(to_json(read_field({{"type", "offset_sdf"}, {"offset", "auto"}}).settings)["offset"], "auto");
  EXPECT_EQ(read_field({{"type", "cone_sdf"}, {"rays", 9}}).settings.samples.site, SampleSite::faces);
  EXPECT_EQ(read_field({{"type", "cone_sdf"}, {"at", {{"surface", 50}}}}).settings.samples,
            (SamplePlan{.site = SampleSite::surface, .count = 50}));
}

TEST(ReadField, TakesTheSmoothing) {
  const Field field = read_field({{"type", "cone_sdf"}, {"bilateral", {{"spatial_width", 0.2}}}});
  EXPECT_EQ(field.settings.smoothing.value().number("spatial_width"), 0.2);
  EXPECT_EQ(to_json(field.settings)["bilateral"]["iterations"], 1);
  EXPECT_FALSE(read_field({{"type", "cone_sdf"}}).settings.smoothing.has_value());
}

TEST(ReadField, SettingsThatATypeDoesNotTakeAreErrors) {
  const auto message = [](const Json& settings) { return test::input_error_of([&] { read_field(settings); }); };
  EXPECT_THAT(message({{"type", "offset_sdf"}}), HasSubstr("offset is missing"));
  EXPECT_THAT(message({{"type", "offset_sdf"}, {"offset", 0}}), HasSubstr("offset is 0"));
  EXPECT_THAT(message({{"type", "cone_sdf"}, {"rays", 0}}), HasSubstr("rays is 0"));
  EXPECT_THAT(message({{"type", "cone_sdf"}, {"opening_angle_degrees", 180}}), HasSubstr("is 180"));
  EXPECT_THAT(message({{"type", "offset_sfd"}}), HasSubstr("did you mean \"offset_sdf\"?"));
}

TEST(ReadField, TakesATypeThatAProgramAdds) {
  const std::size_t known = field_types().entries().size();
  field_types().add(
      {.name = "test_height",
       .description = "Height above the plane z = 0.",
       .parameters = {{.name = "factor", .default_value = 1.0, .description = "What it is multiplied by."}},
       .make = [](const ParameterValues& values, const SamplePlan& /*samples*/) -> FieldComputation {
         return {.versions = {{"test_height", 1}},
                 .compute = [factor = values.number("factor")](FieldSource& /*source*/, const Samples& samples,
                                                               bool /*parallel*/) {
                   return FieldValues{.values = factor * samples.points.col(2)};
                 }};
       }});
  ASSERT_EQ(field_types().entries().size(), known + 1);
  EXPECT_EQ(field_types().names().back(), "test_height");
  const Field field = read_field({{"type", "test_height"}, {"factor", 2}, {"at", "vertices"}});
  EXPECT_EQ(to_json(field.settings), (Json{{"type", "test_height"}, {"factor", 2.0}, {"at", "vertices"}}));
  const Shape shape = test::sphere(1, 1);
  FieldSource source(shape);
  const FieldValues computed = field.compute(source, take_samples(shape, field.settings.samples), false);
  EXPECT_EQ(computed.values, 2 * shape.vertices.col(2));
  EXPECT_EQ(computed.outcomes, (FieldOutcomes{{"total", 42}, {"missing", 0}}));
}

}  // namespace

}  // namespace shapegauge
