#include <gmock/gmock.h>
#include <set>
#include <stdexcept>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/bilateral.h"
#include "shapegauge/core/fields/centricity.h"
#include "shapegauge/core/fields/heat_kernel.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;

TEST(MakeField, OffsetSdfIsThatOfTheCore) {
  const Field field = read_field({{"type", "offset_sdf"}, {"offset", 0.03}, {"at", "vertices"}});
  EXPECT_EQ(field.settings.samples.site, SampleSite::vertices);
  EXPECT_EQ(to_json(field.settings),
            (nlohmann::json{{"type", "offset_sdf"}, {"offset", 0.03}, {"accuracy", "standard"}, {"at", "vertices"}}));
  const Shape shape = test::sphere(1, 1);
  const Samples samples = take_samples(shape, field.settings.samples);
  FieldSource source(shape);
  const FieldValues computed = field.compute(source, samples, false);
  EXPECT_EQ(computed.values, offset_sdf(shape, samples, {.offset = 0.03, .parallel = false}).values);
  EXPECT_EQ(computed.outcomes.at("total"), static_cast<std::size_t>(shape.vertices.rows()));
}

TEST(MakeField, TakesTheAccuracyOfTheOffsetSdf) {
  const Shape shape = test::torus(1, 0.4, 24, 12);
  const Samples samples = sample_shape(shape, SampleSite::faces);
  for (const auto& [word, accuracy] : {std::pair("fast", OffsetAccuracy::fast),
                                       {"standard", OffsetAccuracy::standard},
                                       {"fine", OffsetAccuracy::fine}}) {
    FieldSource source(shape);
    const Field field = read_field({{"type", "offset_sdf"}, {"offset", 0.2}, {"accuracy", word}});
    EXPECT_EQ(field.compute(source, samples, false).values,
              offset_sdf(shape, samples, {.offset = 0.2, .accuracy = accuracy, .parallel = false}).values);
  }
  EXPECT_THROW(read_field({{"type", "offset_sdf"}, {"offset", 0.2}, {"accuracy", "finest"}}), InputError);
}

TEST(MakeField, TakesTheGeodesicsOfCentricity) {
  const Shape shape = test::torus(1, 0.4, 12, 8);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  const auto by = [&](GeodesicMethod method) {
    return centricity(shape, samples, {.geodesics = {.method = method}, .sources = 5});
  };
  ASSERT_FALSE(by(GeodesicMethod::exact).isApprox(by(GeodesicMethod::heat), 1e-3));
  for (const auto& [word, method] :
       {std::pair("graph", GeodesicMethod::graph), {"heat", GeodesicMethod::heat}, {"exact", GeodesicMethod::exact}}) {
    FieldSource source(shape);
    const Field field = read_field({{"type", "centricity"}, {"method", word}, {"sources", 5}, {"at", "vertices"}});
    EXPECT_EQ(field.compute(source, samples, false).values, by(method)) << word;
  }
}

TEST(OutcomeWarnings, AreOfSamplesThatUsersShouldKnowOf) {
  EXPECT_TRUE(outcome_warnings({{"total", 9}, {"direct", 9}, {"missing", 0}}).empty());
  const std::vector<std::string> warnings =
      outcome_warnings({{"total", 9}, {"undecided", 1}, {"missing", 2}, {"enlarged", 9}});
  ASSERT_EQ(warnings.size(), 3U);
  EXPECT_THAT(warnings[0], HasSubstr("1 of 9 samples undecided"));
  EXPECT_THAT(warnings[2], HasSubstr("larger offset"));
}

TEST(MakeField, ConeSdfIsThatOfTheCore) {
  const Field field = read_field({{"type", "cone_sdf"}, {"rays", 9}, {"opening_angle_degrees", 40}});
  EXPECT_EQ(field.settings.samples.site, SampleSite::faces);
  const Shape shape = test::sphere(1, 1);
  const Samples samples = take_samples(shape, field.settings.samples);
  const ConeSdfOptions options{.opening_angle_degrees = 40, .rays = 9, .parallel = false};
  FieldSource source(shape);
  const FieldValues computed = field.compute(source, samples, true);
  EXPECT_EQ(computed.values, cone_sdf(shape, samples, options).values);
  EXPECT_EQ(computed.outcomes, (FieldOutcomes{{"total", 80}, {"missing", 0}}));
}

/// Values of a field on a shape.
Eigen::VectorXd values_of(const nlohmann::json& settings, const Shape& shape) {
  const Field field = read_field(settings);
  FieldSource source(shape);
  return field.compute(source, take_samples(shape, field.settings.samples), false).values;
}

TEST(MakeField, CentricityIsThatOfTheLibrary) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const Samples samples = take_samples(shape, {});
  const CentricityOptions options{.measure = Centricity::eccentricity, .sources = 9};
  EXPECT_EQ(values_of({{"type", "centricity"}, {"measure", "eccentricity"}, {"sources", 9}}, shape),
            centricity(shape, samples, options));
  EXPECT_EQ(values_of({{"type", "centricity"}}, shape), centricity(shape, samples));
}

TEST(MakeField, FieldsOnTheProxyAreThoseOfItsSource) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const Samples samples = take_samples(shape, {});
  ProxySource source(shape);
  EXPECT_EQ(values_of({{"type", "centricity"}, {"on", "proxy"}}, shape),
            source.at_samples(samples, centricity(source.geodesics(), Centricity::mean)));
  const Eigen::VectorXd heat = heat_kernel_signature(source.spectrum(20), source.proxy().areas.sum(), 0.1);
  EXPECT_EQ(values_of({{"type", "heat_kernel"}, {"time", 0.1}, {"eigenvalues", 20}, {"on", "proxy"}}, shape),
            source.at_samples(samples, heat));
  const Shape cloud = test::random_points(shape, 500, 1);
  EXPECT_TRUE(values_of({{"type", "heat_kernel"}, {"on", "proxy"}, {"at", "vertices"}}, cloud).allFinite());
  EXPECT_THROW(read_field({{"type", "centricity"}, {"on", "proxy"}, {"method", "heat"}}), InputError);
}

TEST(MakeField, HeatKernelsAreColumnsOfTheLibrarys) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const double area = surface_area(shape);
  const Spectrum spectrum = laplacian_spectrum(shape, 20);
  EXPECT_TRUE(values_of({{"type", "heat_kernel"}, {"time", 0.1}, {"eigenvalues", 20}, {"at", "vertices"}}, shape)
                  .isApprox(heat_kernel_signature(spectrum, area, 0.1), 1e-12));
  const nlohmann::json invariant{
      {"type", "scale_invariant_heat_kernel"}, {"frequency", 2}, {"eigenvalues", 20}, {"at", "vertices"}};
  EXPECT_TRUE(
      values_of(invariant, shape).isApprox(scale_invariant_heat_kernel_signature(spectrum, area).col(2), 1e-12));
  const nlohmann::json wave{{"type", "wave_kernel"}, {"energy", 3}, {"eigenvalues", 20}, {"at", "vertices"}};
  EXPECT_TRUE(values_of(wave, shape).isApprox(wave_kernel_signature(spectrum, area).col(3), 1e-12));
  EXPECT_THROW(read_field({{"type", "wave_kernel"}, {"energy", 16}}), InputError);
}

TEST(MakeField, AnyFieldMayBeSmoothed) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const Samples samples = take_samples(shape, {});
  const nlohmann::json plain{{"type", "cone_sdf"}, {"rays", 5}};
  nlohmann::json smoothed = plain;
  smoothed["bilateral"] = {{"spatial_width", 0.2}};
  const ScalarField expected = bilateral_smoothing(
      shape, samples, {.values = values_of(plain, shape), .weights = samples.weights}, {.spatial_width = 0.2});
  EXPECT_EQ(values_of(smoothed, shape), expected.values);
  EXPECT_NE(values_of(plain, shape), expected.values);
  const Field field = read_field(smoothed);
  EXPECT_EQ(to_json(field.settings)["bilateral"]["iterations"], 1);
  EXPECT_TRUE(field.versions.contains("bilateral"));
  EXPECT_FALSE(read_field(plain).settings.smoothing.has_value());
}

TEST(MakeField, SecondsAreOfAllThatIsDone) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const Samples samples = take_samples(shape, {});
  const auto compute = [&](const nlohmann::json& settings) {
    FieldSource source(shape);
    return read_field(settings).compute(source, samples, false);
  };
  EXPECT_GT(compute({{"type", "centricity"}}).query_seconds, 0) << "of a field that tells none";
  field_types().add({.name = "test_seconds",
                     .description = "A field that takes no time, and says that it took 1000 seconds.",
                     .parameters = {},
                     .make = [](const ParameterValues& /*values*/, const SamplePlan& /*plan*/) -> FieldComputation {
                       return {.versions = {{"test_seconds", 1}},
                               .compute = [](FieldSource& /*source*/, const Samples& places, bool /*parallel*/) {
                                 return FieldValues{.values = places.points.col(2), .build_seconds = 1000};
                               }};
                     }});
  EXPECT_EQ(compute({{"type", "test_seconds"}}).query_seconds, 0);
  const FieldValues smoothed = compute({{"type", "test_seconds"}, {"bilateral", {{"spatial_width", 0.2}}}});
  EXPECT_EQ(smoothed.build_seconds, 1000);
  EXPECT_GT(smoothed.query_seconds, 0) << "of smoothing";
}

TEST(MakeField, AMissingValueIsCounted) {
  // A single triangle: rays hit nothing.
  Shape shape;
  shape.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  shape.triangles = Triangles{{0, 1, 2}};
  const Field field = read_field({{"type", "cone_sdf"}});
  FieldSource source(shape);
  EXPECT_EQ(field.compute(source, take_samples(shape, field.settings.samples), false).outcomes.at("missing"), 1U);
}

TEST(MakeField, TheAutomaticOffsetIsReported) {
  const Field field = read_field({{"type", "offset_sdf"}, {"offset", "auto"}});
  EXPECT_EQ(to_json(field.settings)["offset"], "auto");
  EXPECT_EQ(field.versions,
            (nlohmann::json{{"offset_sdf", offset_sdf_version}, {"automatic_offset", automatic_offset_version}}));
  const Shape shape = test::sphere(1, 1);
  const Samples samples = take_samples(shape, field.settings.samples);
  FieldSource source(shape);
  const FieldValues computed = field.compute(source, samples, false);
  EXPECT_EQ(computed.offset, automatic_offset(shape).offset);
  const OffsetSdfOptions options{.offset = computed.offset.value(), .parallel = false};
  EXPECT_EQ(computed.values, offset_sdf(shape, samples, options).values);
}

TEST(MakeField, SettingsThatATypeDoesNotTakeAreErrors) {
  const auto message = [](const nlohmann::json& settings) {
    return test::input_error_of([&] { read_field(settings); });
  };
  EXPECT_THAT(message({{"type", "offset_sdf"}}), HasSubstr("offset is missing"));
  EXPECT_THAT(message({{"type", "offset_sdf"}, {"offset", 0}}), HasSubstr("offset is 0"));
  EXPECT_THAT(message({{"type", "cone_sdf"}, {"rays", 0}}), HasSubstr("rays is 0"));
  EXPECT_THAT(message({{"type", "cone_sdf"}, {"opening_angle_degrees", 180}}), HasSubstr("is 180"));
}

TEST(MakeField, AFieldKnowsItsDimension) {
  const auto dimension = [](nlohmann::json settings) { return read_field(settings).dimension; };
  EXPECT_EQ(dimension({{"type", "offset_sdf"}, {"offset", 0.05}}), FieldDimension::length);
  EXPECT_EQ(dimension({{"type", "cone_sdf"}}), FieldDimension::length);
  EXPECT_EQ(dimension({{"type", "cone_sdf"}, {"engine", "cgal"}, {"postprocess", true}}), FieldDimension::none);
  EXPECT_EQ(dimension({{"type", "centricity"}, {"bilateral", {{"iterations", 1}}}}), FieldDimension::length);
  for (const char* type : {"heat_kernel", "scale_invariant_heat_kernel", "wave_kernel"}) {
    EXPECT_EQ(dimension({{"type", type}}), FieldDimension::none) << type;
  }
}

/// Values of a field on a shape without preparation.
Eigen::VectorXd values_on(const Shape& shape, const nlohmann::json& settings) {
  const Field field = read_field(settings);
  FieldSource source(shape);
  return field.compute(source, take_samples(shape, field.settings.samples), false).values;
}

TEST(MakeField, ValuesFollowTheScaleByTheirDimension) {
  const Shape shape = test::box({1, 2, 3}, 4);
  const Shape larger = test::transformed(shape, 3, Eigen::Matrix3d::Identity(), {0, 0, 0});
  for (const FieldType& type : field_types().entries()) {
    if (type.name.starts_with("test_")) continue;
    nlohmann::json settings{{"type", type.name}, {"at", "vertices"}};
    if (type.name == "offset_sdf") settings["offset"] = 0.05;
    if (type.name.ends_with("_kernel")) settings["eigenvalues"] = 20;
    const double factor = unit_of(read_field(settings).dimension, 3);
    EXPECT_TRUE(values_on(larger, settings).isApprox(factor * values_on(shape, settings), 1e-3)) << type.name;
  }
}

TEST(FieldTypes, HaveEachSettingOnce) {
  for (const FieldType& type : field_types().entries()) {
    std::set<std::string> names;
    for (const Parameter& parameter : type.parameters) {
      EXPECT_TRUE(names.emplace(parameter.name).second) << type.name << ": " << parameter.name;
    }
  }
}

TEST(RegisterField, AddsATypeThatConfigurationsCanName) {
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
  EXPECT_EQ(to_json(field.settings), (nlohmann::json{{"type", "test_height"}, {"factor", 2.0}, {"at", "vertices"}}));
  const Shape shape = test::sphere(1, 1);
  FieldSource source(shape);
  const FieldValues computed = field.compute(source, take_samples(shape, field.settings.samples), false);
  EXPECT_EQ(computed.values, 2 * shape.vertices.col(2));
  EXPECT_EQ(computed.outcomes, (FieldOutcomes{{"total", 42}, {"missing", 0}}));
}

TEST(RegisterField, RefusesWhatNoConfigurationCouldName) {
  const auto make = field_types().at("offset_sdf").make;
  EXPECT_THROW(field_types().add({"offset_sdf", "", {}, make}), ArgumentError);
  EXPECT_THROW(field_types().add({"", "", {}, make}), ArgumentError);
  EXPECT_THROW(field_types().add({"test_nothing", "", {}, {}}), ArgumentError);
  EXPECT_THROW(field_types().add({"test_at", "", {{.name = "at", .description = "Where."}}, make}), ArgumentError);
}

TEST(RegisterField, AValueForEachSampleIsNeeded) {
  field_types().add({.name = "test_one_value",
                     .description = "A single value.",
                     .parameters = {},
                     .make = [](const ParameterValues& /*values*/, const SamplePlan& /*samples*/) -> FieldComputation {
                       return {.versions = {{"test_one_value", 1}},
                               .compute = [](FieldSource& /*source*/, const Samples& /*samples*/, bool /*parallel*/) {
                                 return FieldValues{.values = Eigen::VectorXd::Zero(1)};
                               }};
                     }});
  const Field field = read_field({{"type", "test_one_value"}});
  const Shape shape = test::sphere(1, 1);
  FieldSource source(shape);
  EXPECT_THROW(field.compute(source, take_samples(shape, field.settings.samples), false), std::logic_error);
}

TEST(MakeField, AnUnknownTypeIsAnError) {
  EXPECT_THAT(test::input_error_of([] {
                read_field({{"type", "offset_sfd"}});
              }),
              HasSubstr("did you mean \"offset_sdf\"?"));
}

}  // namespace

}  // namespace shapegauge
