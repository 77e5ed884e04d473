// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/field_settings.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "shapegauge/experiments/configuration/parameter_json.h"

namespace shapegauge {

using Json = nlohmann::json;

SamplePlan sample_plan_of(const Json& settings) {
  const auto at = settings.find("at");
  if (at == settings.end()) return {};
  if (at->is_object()) return {.site = SampleSite::surface, .count = at->at(word_of(SampleSite::surface))};
  return {.site = value_of_word<SampleSite>(at->get<std::string>()).value()};
}

Json to_json(const SamplePlan& plan) {
  if (plan.site == SampleSite::surface) return {{word_of(plan.site), plan.count}};
  return word_of(plan.site);
}

Field read_field(const Json& settings) {
  FieldSettings read = field_settings(settings.at("type").get<std::string>());
  read.values = read_parameters(read.values.parameters(), settings);
  read.samples = sample_plan_of(settings);
  if (const auto smoothing = settings.find("bilateral"); smoothing != settings.end()) {
    read.smoothing = read_parameters(bilateral_parameters(), *smoothing);
  }
  return make_field(std::move(read));
}

Json to_json(const FieldSettings& settings) {
  Json json = to_json(settings.values);
  json["type"] = settings.type;
  json["at"] = to_json(settings.samples);
  if (settings.smoothing) json["bilateral"] = to_json(*settings.smoothing);
  return json;
}

}  // namespace shapegauge
