#include "shapegauge/experiments/fields/sample_plan.h"

namespace shapegauge {

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

}  // namespace shapegauge
