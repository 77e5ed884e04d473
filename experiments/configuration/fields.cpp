#include "shapegauge/experiments/configuration/fields.h"

#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"

namespace shapegauge {

/// The field type "cone_sdf": settings `engine`, `opening_angle_degrees`, `rays`, `postprocess` and `at` of cone_sdf
/// (the design, section 2.3). Throws InputError where the engine cannot do what is asked.
Field cone_sdf_field(const nlohmann::json& settings);

/// The field type "offset_sdf": settings `offset`, a fraction of the diagonal or "auto" (automatic_offset), and `at`
/// of offset_sdf (the design, section 2.2).
Field offset_sdf_field(const nlohmann::json& settings);

namespace {

ConeSdfOptions options_of(const nlohmann::json& settings) {
  ConeSdfOptions options;
  options.engine = settings.value("engine", "embree") == "cgal" ? ConeSdfEngine::cgal : ConeSdfEngine::embree;
  options.opening_angle_degrees = settings.value("opening_angle_degrees", options.opening_angle_degrees);
  options.rays = settings.value("rays", options.rays);
  options.postprocess = settings.value("postprocess", options.postprocess);
  return options;
}

}  // namespace

Field cone_sdf_field(const nlohmann::json& settings) {
  const ConeSdfOptions options = options_of(settings);
  const SamplePlan samples_wanted = sample_plan_of(settings);
  const bool cgal = options.engine == ConeSdfEngine::cgal;
  if (options.postprocess && !cgal) {
    throw InputError(R"("postprocess" needs "engine": "cgal"; the embree engine gives raw values only)");
  }
  if (cgal && samples_wanted.site != SampleSite::faces) {
    throw InputError(R"("engine": "cgal" answers at faces only; use "embree" for other sites)");
  }
  return {.settings = {{"type", "cone_sdf"},
                       {"engine", cgal ? "cgal" : "embree"},
                       {"opening_angle_degrees", options.opening_angle_degrees},
                       {"rays", options.rays},
                       {"postprocess", options.postprocess},
                       {"at", to_json(samples_wanted)}},
          .versions = {{"cone_sdf", cone_sdf_version}},
          .samples = samples_wanted,
          .compute = [options](const FieldSource& source, const Samples& samples, bool parallel) {
            ConeSdfOptions now = options;
            now.parallel = parallel;
            ConeSdfResult result = cone_sdf(source.shape(), samples, now);
            const auto total = static_cast<std::size_t>(result.values.size());
            return FieldValues{.values = std::move(result.values),
                               .outcomes = {{"total", total}, {"missing", result.missing}},
                               .offset = {},
                               .build_seconds = result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

Field offset_sdf_field(const nlohmann::json& settings) {
  const nlohmann::json& offset = settings.at("offset");
  const bool automatic = offset.is_string();  // "auto", as the schema says
  const double given = automatic ? 0 : offset.get<double>();
  const SamplePlan samples_wanted = sample_plan_of(settings);
  nlohmann::json versions{{"offset_sdf", offset_sdf_version}};
  if (automatic) versions["automatic_offset"] = automatic_offset_version;
  return {.settings = {{"type", "offset_sdf"}, {"offset", offset}, {"at", to_json(samples_wanted)}},
          .versions = versions,
          .samples = samples_wanted,
          .compute = [automatic, given](FieldSource& source, const Samples& samples, bool parallel) {
            const double r = automatic ? automatic_offset(source.shape()).offset : given;
            const OffsetSdfOptions now{.offset = r, .parallel = parallel};
            const OffsetSdfSolver& solver = source.offset_sdf_solver();
            OffsetSdfResult result = solver.solve(samples, now);
            const OffsetSdfOutcomes& outcomes = result.outcomes;
            return FieldValues{.values = std::move(result.values),
                               .normals = std::move(result.normals),
                               .outcomes = {{"total", outcomes.total},
                                            {"direct", outcomes.direct},
                                            {"searched", outcomes.searched},
                                            {"undecided", outcomes.undecided},
                                            {"missing", outcomes.missing}},
                               .offset = automatic ? std::optional(r) : std::nullopt,
                               .build_seconds = solver.build_seconds() + result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

SamplePlan sample_plan_of(const nlohmann::json& settings) {
  const auto at = settings.find("at");
  if (at == settings.end()) return {};
  if (at->is_object()) return {.site = SampleSite::surface, .count = at->at("surface")};
  return {.site = *at == "vertices" ? SampleSite::vertices : SampleSite::faces};
}

nlohmann::json to_json(const SamplePlan& plan) {
  if (plan.site == SampleSite::surface) return {{"surface", plan.count}};
  return plan.site == SampleSite::vertices ? "vertices" : "faces";
}

Samples take_samples(const Shape& shape, const SamplePlan& plan) {
  return plan.site == SampleSite::surface ? sample_surface_of(shape, plan.count) : sample_shape(shape, plan.site);
}

std::span<const FieldType> field_types() {
  static constexpr std::array types{
      FieldType{"offset_sdf", offset_sdf_field},
      FieldType{"cone_sdf", cone_sdf_field},
  };
  return types;
}

Field make_field(const nlohmann::json& settings) {
  const std::string type = settings.at("type");
  for (const FieldType& known : field_types()) {
    if (known.name == type) return known.make(settings);
  }
  throw InputError(fmt::format("there is no field of type \"{}\"", type));
}

}  // namespace shapegauge
