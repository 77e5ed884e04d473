// SPDX-License-Identifier: GPL-3.0-or-later
// The SDFs and other measures of thickness as fields.

#include <array>
#include <optional>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/field_types.h"
#include "shapegauge/core/fields/inscribed_ball.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"

namespace shapegauge {

namespace {

constexpr std::array<std::string_view, 1> automatic{"auto"};

/// Returns the parameters of an offset SDF: the offset is mandatory and may be automatic.
std::vector<Parameter> offset_sdf_parameters() {
  Parameter offset = parameter_named("offset", offset_sdf_table);
  offset.default_value = {};
  offset.choices = automatic;
  offset.description =
      "Distance of the offset surface; auto: for each shape, the smallest from 0.01 to 0.05 that closes gaps and "
      "smooths noise.";
  return {offset, parameter_named("accuracy", offset_sdf_table)};
}

FieldComputation offset_sdf_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const auto* const number = std::get_if<double>(&values.value("offset"));
  const std::optional<double> offset = number != nullptr ? std::optional(*number) : std::nullopt;  // else "auto"
  const auto accuracy = member_value<OffsetAccuracy>(values.value("accuracy"));
  AlgorithmVersions versions{{"offset_sdf", offset_sdf_version}};
  if (!offset) versions["automatic_offset"] = automatic_offset_version;
  return {.versions = std::move(versions),
          .compute = [offset, accuracy](FieldSource& source, const Samples& samples, bool parallel) {
            OffsetSdfOptions options{.accuracy = accuracy, .parallel = parallel};
            options.offset = offset ? *offset : source.automatic_offset().offset;
            const OffsetSdfSolver& solver = source.offset_sdf_solver();
            OffsetSdfResult result = solver.solve(samples, options);
            return FieldValues{.values = std::move(result.values),
                               .normals = std::move(result.normals),
                               .outcomes = field_outcomes(result.outcomes),
                               .offset = offset ? std::nullopt : std::optional(options.offset),
                               .build_seconds = solver.build_seconds() + result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

FieldComputation cone_sdf_field(const ParameterValues& values, const SamplePlan& samples) {
  const ConeSdfOptions options = options_from(cone_sdf_table, values);
  const bool cgal = options.engine == ConeSdfEngine::cgal;
  if (options.postprocess && !cgal) {
    throw InputError(R"("postprocess" needs "engine": "cgal"; the embree engine returns raw values only)");
  }
  if (cgal && samples.site != SampleSite::faces) {
    throw InputError(R"("engine": "cgal" supports faces only; for other values of "at" use "embree")");
  }
  // CGAL's post-processing scales to [0, 1].
  return {.versions = {{"cone_sdf", cone_sdf_version}},
          .dimension = options.postprocess ? FieldDimension::none : FieldDimension::length,
          .compute = [options](const FieldSource& source, const Samples& sites, bool parallel) {
            ConeSdfOptions now = options;
            now.parallel = parallel;
            ConeSdfResult result = cone_sdf(source.shape(), sites, now);
            return FieldValues{.values = std::move(result.values),
                               .build_seconds = result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

/// Returns the field of the balls on a side of the surface.
FieldComputation touching_ball_field(const ParameterValues& values, BallSide side) {
  return {.versions = {{"inscribed_ball", inscribed_ball_version}},
          .compute = [options = options_from(inscribed_ball_table, values), side](
                         const FieldSource& source, const Samples& samples, bool parallel) {
            InscribedBallOptions now = options;
            now.parallel = parallel;
            return FieldValues{.values = TouchingBalls(source.shape(), now).diameters(samples, side)};
          }};
}

FieldComputation inscribed_ball_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  return touching_ball_field(values, BallSide::inside);
}

FieldComputation gap_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  return touching_ball_field(values, BallSide::outside);
}

}  // namespace

FieldOutcomes field_outcomes(const OffsetSdfOutcomes& outcomes) {
  return {{"total", outcomes.total},         {"direct", outcomes.direct},   {"searched", outcomes.searched},
          {"undecided", outcomes.undecided}, {"missing", outcomes.missing}, {"two_sided", outcomes.two_sided},
          {"enlarged", outcomes.enlarged}};
}

FieldType offset_sdf_type() {
  return {"offset_sdf", "Shape diameter function of the offset surface.", offset_sdf_parameters(), offset_sdf_field,
          true};
}

FieldType cone_sdf_type() {
  constexpr auto parameters = parameters_of(cone_sdf_table);
  return {"cone_sdf",
          "Conventional shape diameter function (cone of rays).",
          {parameters.begin(), parameters.end()},
          cone_sdf_field,
          true};
}

FieldType inscribed_ball_type() {
  constexpr auto parameters = parameters_of(inscribed_ball_table);
  return {"inscribed_ball",
          "Diameter of the largest inner ball touching the surface at the sample.",
          {parameters.begin(), parameters.end()},
          inscribed_ball_field,
          true};
}

FieldType gap_type() {
  constexpr auto parameters = parameters_of(inscribed_ball_table);
  return {"gap",
          "Diameter of the largest empty ball touching the surface at the sample from outside.",
          {parameters.begin(), parameters.end()},
          gap_field};
}

}  // namespace shapegauge
