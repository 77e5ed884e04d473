// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <initializer_list>
#include <set>
#include <stdexcept>
#include <string>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/bilateral.h"
#include "shapegauge/core/fields/centricity.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/fields/heat_kernel.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using Values = std::initializer_list<std::pair<const char*, ParameterValue>>;

constexpr SamplePlan vertex_plan{.site = SampleSite::vertices};

/// Settings of a type with other values than its defaults.
FieldSettings settings_of(std::string_view type, Values changed = {}, SamplePlan samples = {}) {
  FieldSettings settings = field_settings(type);
  settings.samples = samples;
  for (const auto& [name, value] : changed) settings.values.set(name, value);
  return settings;
}

FieldSettings smoothed(FieldSettings settings, Values changed) {
  settings.smoothing = ParameterValues(bilateral_parameters());
  for (const auto& [name, value] : changed) settings.smoothing->set(name, value);
  return settings;
}

FieldValues compute(const Field& field, const Shape& shape) {
  FieldSource source(shape);
  return field.compute(source, take_samples(shape, field.settings.samples), false);
}

Eigen::VectorXd values_of(const FieldSettings& settings, const Shape& shape) {
  return compute(make_field(settings), shape).values;
}

TEST(MakeField, OffsetSdfFieldEqualsADirectCallOfOffsetSdf) {
  const Shape shape = test::sphere(1, 1);
  const FieldValues computed = compute(make_field(settings_of("offset_sdf", {{"offset", 0.03}}, vertex_plan)), shape);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  EXPECT_EQ(computed.values, offset_sdf(shape, samples, {.offset = 0.03, .parallel = false}).values);
  EXPECT_EQ(computed.outcomes.at("total"), static_cast<std::size_t>(shape.vertices.rows()));
}

TEST(MakeField, OffsetSdfFieldUsesTheAccuracySetting) {
  const Shape shape = test::torus(1, 0.4, 24, 12);
  const Samples samples = sample_shape(shape, SampleSite::faces);
  for (const auto& [word, accuracy] : {std::pair("fast", OffsetAccuracy::fast),
                                       {"standard", OffsetAccuracy::standard},
                                       {"fine", OffsetAccuracy::fine}}) {
    EXPECT_EQ(values_of(settings_of("offset_sdf", {{"offset", 0.2}, {"accuracy", word}}), shape),
              offset_sdf(shape, samples, {.offset = 0.2, .accuracy = accuracy, .parallel = false}).values);
  }
  EXPECT_THROW(settings_of("offset_sdf", {{"accuracy", "finest"}}), InputError);
}

TEST(MakeField, CentricityFieldUsesTheGeodesicMethodSetting) {
  const Shape shape = test::torus(1, 0.4, 12, 8);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  const auto by = [&](GeodesicMethod method) {
    return centricity(shape, samples, {.geodesics = {.method = method}, .sources = 5});
  };
  ASSERT_FALSE(by(GeodesicMethod::exact).isApprox(by(GeodesicMethod::heat), 1e-3));
  for (const auto& [word, method] :
       {std::pair("graph", GeodesicMethod::graph), {"heat", GeodesicMethod::heat}, {"exact", GeodesicMethod::exact}}) {
    EXPECT_EQ(values_of(settings_of("centricity", {{"method", word}, {"sources", 5}}, vertex_plan), shape), by(method))
        << word;
  }
}

TEST(WeightsWarning, IsGivenIfTriangleAreasOverflowOrUnderflow) {
  const Shape box = test::box({1, 2, 3}, 1);
  for (const double scale : {1.0, 1e30, 1e-30}) {
    const Shape scaled = test::transformed(box, scale, Eigen::Matrix3d::Identity(), {0, 0, 0});
    EXPECT_EQ(weights_warning(sample_shape(scaled, SampleSite::faces)), std::nullopt) << scale;
  }
  const auto warning_at = [&](double scale) {
    const Shape scaled = test::transformed(box, scale, Eigen::Matrix3d::Identity(), {0, 0, 0});
    return weights_warning(sample_shape(scaled, SampleSite::faces)).value_or("");
  };
  EXPECT_THAT(warning_at(1e160), HasSubstr("too large"));
  EXPECT_THAT(warning_at(1e-170), HasSubstr("the sum 0"));
  EXPECT_THAT(warning_at(1e-160), HasSubstr("too small")) << "subnormal";
}

TEST(OutcomeWarnings, WarnOfUndecidedAndMissingSamplesAndEnlargedOffsets) {
  EXPECT_TRUE(outcome_warnings({{"total", 9}, {"direct", 9}, {"missing", 0}}).empty());
  const std::vector<std::string> warnings =
      outcome_warnings({{"total", 9}, {"undecided", 1}, {"missing", 2}, {"enlarged", 9}});
  ASSERT_EQ(warnings.size(), 3U);
  EXPECT_THAT(warnings[0], HasSubstr("1 of 9 samples undecided"));
  EXPECT_THAT(warnings[2], HasSubstr("larger offset"));
}

TEST(MakeField, ConeSdfFieldEqualsADirectCallOfConeSdf) {
  const Shape shape = test::sphere(1, 1);
  const Field field = make_field(settings_of("cone_sdf", {{"rays", 9}, {"opening_angle_degrees", 40}}));
  EXPECT_EQ(field.settings.samples.site, SampleSite::faces);
  const Samples samples = take_samples(shape, field.settings.samples);
  const ConeSdfOptions options{.opening_angle_degrees = 40, .rays = 9, .parallel = false};
  FieldSource source(shape);
  const FieldValues computed = field.compute(source, samples, true);
  EXPECT_EQ(computed.values, cone_sdf(shape, samples, options).values);
  EXPECT_EQ(computed.outcomes, (FieldOutcomes{{"total", 80}, {"missing", 0}}));
}

TEST(MakeField, CentricityFieldEqualsADirectCallOfCentricity) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const Samples samples = take_samples(shape, {});
  const CentricityOptions options{.measure = Centricity::eccentricity, .sources = 9};
  EXPECT_EQ(values_of(settings_of("centricity", {{"measure", "eccentricity"}, {"sources", 9}}), shape),
            centricity(shape, samples, options));
  EXPECT_EQ(values_of(settings_of("centricity"), shape), centricity(shape, samples));
}

TEST(MakeField, FieldsOnTheSurfaceProxyEqualValuesInterpolatedFromItsPoints) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const Samples samples = take_samples(shape, {});
  ProxySource source(shape);
  EXPECT_EQ(values_of(settings_of("centricity", {{"on", "proxy"}}), shape),
            source.interpolate_to_samples(samples, centricity(source.geodesics(), Centricity::mean)));
  const Eigen::VectorXd heat = heat_kernel_signature(source.spectrum(20), source.proxy().areas.sum(), 0.1);
  EXPECT_EQ(values_of(settings_of("heat_kernel", {{"time", 0.1}, {"eigenvalues", 20}, {"on", "proxy"}}), shape),
            source.interpolate_to_samples(samples, heat));
  const Shape cloud = test::random_points(shape, 500, 1);
  EXPECT_TRUE(values_of(settings_of("heat_kernel", {{"on", "proxy"}}, vertex_plan), cloud).allFinite());
  EXPECT_THROW(make_field(settings_of("centricity", {{"on", "proxy"}, {"method", "heat"}})), InputError);
}

TEST(MakeField, HeatKernelFieldsEqualDirectCallsOfTheirSignatures) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const double area = surface_area(shape);
  const Spectrum spectrum = laplacian_spectrum(shape, 20);
  EXPECT_TRUE(values_of(settings_of("heat_kernel", {{"time", 0.1}, {"eigenvalues", 20}}, vertex_plan), shape)
                  .isApprox(heat_kernel_signature(spectrum, area, 0.1), 1e-12));
  const FieldSettings invariant =
      settings_of("scale_invariant_heat_kernel", {{"frequency", 2}, {"eigenvalues", 20}}, vertex_plan);
  EXPECT_TRUE(
      values_of(invariant, shape).isApprox(scale_invariant_heat_kernel_signature(spectrum, area).col(2), 1e-12));
  const FieldSettings wave = settings_of("wave_kernel", {{"energy", 3}, {"eigenvalues", 20}}, vertex_plan);
  EXPECT_TRUE(values_of(wave, shape).isApprox(wave_kernel_signature(spectrum, area).col(3), 1e-12));
  EXPECT_THROW(make_field(settings_of("wave_kernel", {{"energy", 16}})), InputError);
}

TEST(MakeField, AppliesBilateralSmoothingToAnyField) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  const Samples samples = take_samples(shape, {});
  const FieldSettings plain = settings_of("cone_sdf", {{"rays", 5}});
  const FieldSettings smooth = smoothed(plain, {{"spatial_width", 0.2}});
  const ScalarField expected = bilateral_smoothing(
      shape, samples, {.values = values_of(plain, shape), .weights = samples.weights}, {.spatial_width = 0.2});
  EXPECT_EQ(values_of(smooth, shape), expected.values);
  EXPECT_NE(values_of(plain, shape), expected.values);
  EXPECT_TRUE(make_field(smooth).versions.contains("bilateral"));
  EXPECT_FALSE(make_field(plain).versions.contains("bilateral"));
}

TEST(MakeField, ReportedRunTimeIncludesComputationAndSmoothing) {
  const Shape shape = test::capsule(0.3, 1, 12, 6);
  EXPECT_GT(compute(make_field(settings_of("centricity")), shape).query_seconds, 0) << "of a field that tells none";
  field_types().add({.name = "test_seconds",
                     .description = "A field that takes no time, and says that it took 1000 seconds.",
                     .parameters = {},
                     .make = [](const ParameterValues& /*values*/, const SamplePlan& /*plan*/) -> FieldComputation {
                       return {.versions = {{"test_seconds", 1}},
                               .compute = [](FieldSource& /*source*/, const Samples& samples, bool /*parallel*/) {
                                 return FieldValues{.values = samples.points.col(2), .build_seconds = 1000};
                               }};
                     }});
  EXPECT_EQ(compute(make_field(settings_of("test_seconds")), shape).query_seconds, 0);
  const FieldValues smooth =
      compute(make_field(smoothed(settings_of("test_seconds"), {{"spatial_width", 0.2}})), shape);
  EXPECT_EQ(smooth.build_seconds, 1000);
  EXPECT_GT(smooth.query_seconds, 0) << "of smoothing";
}

TEST(MakeField, CountsMissingValues) {
  // A single triangle: rays hit nothing.
  const Shape shape{.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = Triangles{{0, 1, 2}}};
  EXPECT_EQ(compute(make_field(settings_of("cone_sdf")), shape).outcomes.at("missing"), 1U);
}

TEST(MakeField, ReportsTheAutomaticOffset) {
  const Field field = make_field(settings_of("offset_sdf", {{"offset", "auto"}}));
  EXPECT_EQ(field.versions,
            (AlgorithmVersions{{"offset_sdf", offset_sdf_version}, {"automatic_offset", automatic_offset_version}}));
  const Shape shape = test::sphere(1, 1);
  const FieldValues computed = compute(field, shape);
  EXPECT_EQ(computed.offset, automatic_offset(shape).offset);
  const OffsetSdfOptions options{.offset = computed.offset.value(), .parallel = false};
  EXPECT_EQ(computed.values, offset_sdf(shape, take_samples(shape, {}), options).values);
}

TEST(MakeField, RejectsMissingMandatorySettings) {
  EXPECT_THAT(test::input_error_of([] { make_field(settings_of("offset_sdf")); }), HasSubstr("offset is missing"));
}

TEST(MakeField, StatesWhetherValuesAreLengthsOrDimensionless) {
  const auto dimension = [](const FieldSettings& settings) { return make_field(settings).dimension; };
  EXPECT_EQ(dimension(settings_of("offset_sdf", {{"offset", 0.05}})), FieldDimension::length);
  EXPECT_EQ(dimension(settings_of("cone_sdf")), FieldDimension::length);
  EXPECT_EQ(dimension(settings_of("cone_sdf", {{"engine", "cgal"}, {"postprocess", true}})), FieldDimension::none);
  EXPECT_EQ(dimension(smoothed(settings_of("centricity"), {{"iterations", 1}})), FieldDimension::length);
  for (const char* type : {"heat_kernel", "scale_invariant_heat_kernel", "wave_kernel"}) {
    EXPECT_EQ(dimension(settings_of(type)), FieldDimension::none) << type;
  }
}

/// Settings of each type of the library, at vertices.
std::vector<FieldSettings> settings_of_all_types() {
  std::vector<FieldSettings> all;
  for (const FieldType& type : field_types().entries()) {
    if (type.name.starts_with("test_")) continue;
    all.push_back(settings_of(type.name, {}, vertex_plan));
    if (type.name == "offset_sdf") all.back().values.set("offset", 0.05);
    if (type.name.ends_with("_kernel")) all.back().values.set("eigenvalues", 20);
  }
  return all;
}

/// A box, or two next to each other for the gap between them.
Shape boxes_for(const FieldSettings& settings) {
  const Shape box = test::box({1, 2, 3}, 4);
  if (settings.type != "gap") return box;
  return test::joined({box, test::transformed(box, 1, Eigen::Matrix3d::Identity(), {0, 0, 3.5})});
}

Eigen::VectorXd zero_if_missing(const Eigen::VectorXd& values) {
  return values.unaryExpr([](double value) { return std::isnan(value) ? 0.0 : value; });
}

TEST(MakeField, ValuesScaleWithTheShapeAccordingToTheirDimension) {
  for (const FieldSettings& settings : settings_of_all_types()) {
    const Shape shape = boxes_for(settings);
    const Shape larger = test::transformed(shape, 3, Eigen::Matrix3d::Identity(), {0, 0, 0});
    const double factor = unit_of(make_field(settings).dimension, 3);
    const Eigen::VectorXd values = zero_if_missing(values_of(settings, shape));
    EXPECT_GT(values.norm(), 0) << settings.type;
    EXPECT_TRUE(zero_if_missing(values_of(settings, larger)).isApprox(factor * values, 1e-3)) << settings.type;
  }
}

TEST(MakeField, ValuesAreTheSameOnAnyNumberOfThreads) {
  std::vector<FieldSettings> all = settings_of_all_types();
  all.push_back(settings_of("centricity", {{"on", "proxy"}}, vertex_plan));
  all.push_back(settings_of("heat_kernel", {{"on", "proxy"}, {"eigenvalues", 20}}, vertex_plan));
  all.push_back(smoothed(settings_of("cone_sdf"), {{"spatial_width", 0.2}}));
  const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 8);
  const auto expect_same = [](const FieldSettings& settings, const Shape& shape) {
    const Field field = make_field(settings);
    const Eigen::VectorXd expected = zero_if_missing(compute(field, shape).values);
    for (const int threads : {1, 7}) {
      const Eigen::VectorXd found = tbb::task_arena(threads).execute([&]() -> Eigen::VectorXd {
        FieldSource source(shape);
        return field.compute(source, take_samples(shape, settings.samples), true).values;
      });
      EXPECT_EQ(zero_if_missing(found), expected) << settings.type << " on " << threads;
    }
  };
  for (const FieldSettings& settings : all) expect_same(settings, boxes_for(settings));
  const Shape cloud = test::random_points(test::torus(1, 0.4, 24, 12), 2000, 1);
  expect_same(settings_of("heat_kernel", {{"on", "proxy"}, {"eigenvalues", 20}}, vertex_plan), cloud);
}

TEST(FieldTypes, HaveUniqueSettingNames) {
  for (const FieldType& type : field_types().entries()) {
    std::set<std::string> names;
    for (const Parameter& parameter : type.parameters) {
      EXPECT_TRUE(names.emplace(parameter.name).second) << type.name << ": " << parameter.name;
    }
  }
}

TEST(FieldTypes, RejectDuplicateAndEmptyNamesAndMissingFunctions) {
  const auto make = field_types().at("offset_sdf").make;
  EXPECT_THROW(field_types().add({"offset_sdf", "", {}, make}), ArgumentError);
  EXPECT_THROW(field_types().add({"", "", {}, make}), ArgumentError);
  EXPECT_THROW(field_types().add({"test_nothing", "", {}, {}}), ArgumentError);
  EXPECT_THROW(field_types().add({"test_at", "", {{.name = "at", .description = "Where."}}, make}), ArgumentError);
}

TEST(FieldTypes, AreRejectedUnlessTheyReturnOneValuePerSample) {
  field_types().add({.name = "test_one_value",
                     .description = "A single value.",
                     .parameters = {},
                     .make = [](const ParameterValues& /*values*/, const SamplePlan& /*samples*/) -> FieldComputation {
                       return {.versions = {{"test_one_value", 1}},
                               .compute = [](FieldSource& /*source*/, const Samples& /*samples*/, bool /*parallel*/) {
                                 return FieldValues{.values = Eigen::VectorXd::Zero(1)};
                               }};
                     }});
  const Field field = make_field(settings_of("test_one_value"));
  EXPECT_THROW(compute(field, test::sphere(1, 1)), std::logic_error);
}

TEST(FieldTypes, SuggestTheNearestNameForUnknownTypes) {
  EXPECT_THAT(test::input_error_of([] { field_settings("offset_sfd"); }), HasSubstr("did you mean \"offset_sdf\"?"));
}

}  // namespace

}  // namespace shapegauge
