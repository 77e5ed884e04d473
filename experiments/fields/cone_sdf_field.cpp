#include "shapegauge/experiments/fields/cone_sdf_field.h"

#include "shapegauge/core/error.h"
#include "shapegauge/core/sdf/cone_sdf.h"

namespace shapegauge {

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

}  // namespace shapegauge
