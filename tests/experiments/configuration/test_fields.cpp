#include <gmock/gmock.h>

#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/configuration/fields.h"
#include "tests/core/test_shapes.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;

TEST(MakeField, OffsetSdfIsThatOfTheCore) {
  const Field field = make_field({{"type", "offset_sdf"}, {"offset", 0.03}, {"at", "vertices"}});
  EXPECT_EQ(field.samples.site, SampleSite::vertices);
  EXPECT_EQ(field.settings, (nlohmann::json{{"type", "offset_sdf"}, {"offset", 0.03}, {"at", "vertices"}}));
  const Shape shape = test_shapes::sphere(1, 1);
  const Samples samples = take_samples(shape, field.samples);
  FieldSource source(shape);
  const FieldValues computed = field.compute(source, samples, false);
  EXPECT_EQ(computed.values, offset_sdf(shape, samples, {.offset = 0.03, .parallel = false}).values);
  EXPECT_EQ(computed.outcomes.at("total"), static_cast<std::size_t>(shape.vertices.rows()));
}

TEST(MakeField, ConeSdfIsThatOfTheCore) {
  const Field field = make_field({{"type", "cone_sdf"}, {"rays", 9}, {"opening_angle_degrees", 40}});
  EXPECT_EQ(field.samples.site, SampleSite::faces);
  const Shape shape = test_shapes::sphere(1, 1);
  const Samples samples = take_samples(shape, field.samples);
  const ConeSdfOptions options{.opening_angle_degrees = 40, .rays = 9, .parallel = false};
  FieldSource source(shape);
  const FieldValues computed = field.compute(source, samples, true);
  EXPECT_EQ(computed.values, cone_sdf(shape, samples, options).values);
  EXPECT_EQ(computed.outcomes, (FieldOutcomes{{"total", 80}, {"missing", 0}}));
}

TEST(MakeField, AMissingValueIsCounted) {
  // A single triangle: no ray meets anything.
  Shape shape;
  shape.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  shape.triangles = Triangles{{0, 1, 2}};
  const Field field = make_field({{"type", "cone_sdf"}});
  FieldSource source(shape);
  EXPECT_EQ(field.compute(source, take_samples(shape, field.samples), false).outcomes.at("missing"), 1U);
}

TEST(MakeField, AnUnknownTypeIsAnError) {
  EXPECT_THAT(input_error_of([] { make_field({{"type", "heat"}}); }), HasSubstr("no field of type \"heat\""));
}

}  // namespace

}  // namespace shapegauge
