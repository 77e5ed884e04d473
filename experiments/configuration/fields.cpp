#include "shapegauge/experiments/configuration/fields.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/configuration/nearest_word.h"
#include "shapegauge/experiments/configuration/parameter_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// The SDF of the offset surface (offset_sdf.h).
FieldComputation offset_sdf_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const auto* const given = std::get_if<double>(&values.value("offset"));
  const std::optional<double> offset = given != nullptr ? std::optional(*given) : std::nullopt;  // else "auto"
  Json versions{{"offset_sdf", offset_sdf_version}};
  if (!offset) versions["automatic_offset"] = automatic_offset_version;
  return {.versions = std::move(versions),
          .compute = [offset](FieldSource& source, const Samples& samples, bool parallel) {
            OffsetSdfOptions options{.parallel = parallel};
            options.offset = offset ? *offset : automatic_offset(source.shape()).offset;
            const OffsetSdfSolver& solver = source.offset_sdf_solver();
            OffsetSdfResult result = solver.solve(samples, options);
            const OffsetSdfOutcomes& outcomes = result.outcomes;
            return FieldValues{.values = std::move(result.values),
                               .normals = std::move(result.normals),
                               .outcomes = {{"total", outcomes.total},
                                            {"direct", outcomes.direct},
                                            {"searched", outcomes.searched},
                                            {"undecided", outcomes.undecided},
                                            {"missing", outcomes.missing}},
                               .offset = offset ? std::nullopt : std::optional(options.offset),
                               .build_seconds = solver.build_seconds() + result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

constexpr std::array<std::string_view, 1> automatic{"auto"};

std::vector<Parameter> offset_sdf_parameters() {
  return {{.name = "offset",
           .bounds = OffsetSdfOptions::offset_bounds,
           .choices = automatic,
           .description = "Offset distance as a fraction of the bounding box's diagonal; auto: chosen for each shape "
                          "between 1 and 5 % by its gaps and its noise."}};
}

constexpr std::array<std::string_view, 2> engines{"embree", "cgal"};

/// The conventional SDF (cone_sdf.h).
FieldComputation cone_sdf_field(const ParameterValues& values, const SamplePlan& samples) {
  const bool cgal = values.word("engine") == "cgal";
  const ConeSdfOptions options{.engine = cgal ? ConeSdfEngine::cgal : ConeSdfEngine::embree,
                               .opening_angle_degrees = values.number("opening_angle_degrees"),
                               .rays = static_cast<int>(values.integer("rays")),
                               .postprocess = values.boolean("postprocess")};
  if (options.postprocess && !cgal) {
    throw InputError(R"("postprocess" needs "engine": "cgal"; the embree engine gives raw values only)");
  }
  if (cgal && samples.site != SampleSite::faces) {
    throw InputError(R"("engine": "cgal" answers at faces only; use "embree" for other sites)");
  }
  return {.versions = {{"cone_sdf", cone_sdf_version}},
          .compute = [options](const FieldSource& source, const Samples& sites, bool parallel) {
            ConeSdfOptions now = options;
            now.parallel = parallel;
            ConeSdfResult result = cone_sdf(source.shape(), sites, now);
            return FieldValues{.values = std::move(result.values),
                               .build_seconds = result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

std::vector<Parameter> cone_sdf_parameters() {
  const ConeSdfOptions usual;
  return {{.name = "engine",
           .kind = ParameterKind::choice,
           .default_value = engines[0],
           .choices = engines,
           .description = "Who casts the rays: embree is fast; cgal is CGAL's own, the reference, at faces only."},
          {.name = "opening_angle_degrees",
           .default_value = usual.opening_angle_degrees,
           .bounds = ConeSdfOptions::opening_angle_degrees_bounds,
           .description = "Full opening angle of the cone."},
          {.name = "rays",
           .kind = ParameterKind::integer,
           .default_value = std::int64_t{usual.rays},
           .bounds = ConeSdfOptions::rays_bounds,
           .description = "Number of rays."},
          {.name = "postprocess",
           .kind = ParameterKind::boolean,
           .default_value = usual.postprocess,
           .description = "CGAL's post-processing: smoothed and scaled to [0, 1] shape by shape; engine cgal only."}};
}

std::vector<FieldType>& registry() {
  static std::vector<FieldType> types{
      {"offset_sdf", "Shape diameter function of the offset surface.", offset_sdf_parameters(), offset_sdf_field},
      {"cone_sdf", "Conventional shape diameter function: a cone of rays about the inward normal.",
       cone_sdf_parameters(), cone_sdf_field},
  };
  return types;
}

/// The function, with what every field tells: its own outcomes, or those that can be counted.
FieldFunction with_outcomes(FieldFunction compute) {
  return [compute = std::move(compute)](FieldSource& source, const Samples& samples, bool parallel) {
    FieldValues computed = compute(source, samples, parallel);
    if (computed.values.size() != samples.points.rows()) {
      throw std::logic_error(
          fmt::format("a field gives {} values for {} samples", computed.values.size(), samples.points.rows()));
    }
    if (computed.outcomes.empty()) {
      computed.outcomes = {{"total", static_cast<std::size_t>(computed.values.size())},
                           {"missing", static_cast<std::size_t>(computed.values.array().isNaN().count())}};
    }
    return computed;
  };
}

}  // namespace

FieldSource::FieldSource(const Shape& shape) : shape_(&shape) {}

FieldSource::~FieldSource() = default;

const OffsetSdfSolver& FieldSource::offset_sdf_solver() {
  if (!offset_sdf_solver_) offset_sdf_solver_ = std::make_unique<OffsetSdfSolver>(*shape_);
  return *offset_sdf_solver_;
}

SamplePlan sample_plan_of(const Json& settings) {
  const auto at = settings.find("at");
  if (at == settings.end()) return {};
  if (at->is_object()) return {.site = SampleSite::surface, .count = at->at("surface")};
  return {.site = *at == "vertices" ? SampleSite::vertices : SampleSite::faces};
}

Json to_json(const SamplePlan& plan) {
  if (plan.site == SampleSite::surface) return {{"surface", plan.count}};
  return plan.site == SampleSite::vertices ? "vertices" : "faces";
}

Samples take_samples(const Shape& shape, const SamplePlan& plan) {
  return plan.site == SampleSite::surface ? sample_surface_of(shape, plan.count) : sample_shape(shape, plan.site);
}

std::span<const FieldType> field_types() { return registry(); }

void register_field(FieldType type) {
  const auto reserved = [](const Parameter& parameter) { return parameter.name == "type" || parameter.name == "at"; };
  const bool known = std::ranges::find(registry(), type.name, &FieldType::name) != registry().end();
  if (type.name.empty() || known || !type.make || std::ranges::any_of(type.parameters, reserved)) {
    throw std::invalid_argument(fmt::format(
        "a field needs a name of its own, a function, and parameters that are not called type or at: \"{}\"",
        type.name));
  }
  registry().push_back(std::move(type));
}

Field make_field(const Json& settings) {
  const std::string name = settings.at("type");
  const auto type = std::ranges::find(registry(), name, &FieldType::name);
  if (type == registry().end()) {
    std::vector<std::string> names;
    for (const FieldType& known : registry()) names.push_back(known.name);
    throw InputError(fmt::format("there is no field of type \"{}\"{}", name, suggestion(name, names)));
  }
  const ParameterValues values = read_parameters(type->parameters, settings);
  Field field;
  field.samples = sample_plan_of(settings);
  FieldComputation computation = type->make(values, field.samples);
  field.versions = std::move(computation.versions);
  field.compute = with_outcomes(std::move(computation.compute));
  field.settings = to_json(values);
  field.settings["type"] = name;
  field.settings["at"] = to_json(field.samples);
  return field;
}

}  // namespace shapegauge
