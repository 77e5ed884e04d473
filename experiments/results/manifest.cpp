#include "shapegauge/experiments/results/manifest.h"

#include <tbb/parallel_for.h>

#include "shapegauge/core/version.h"
#include "shapegauge/experiments/results/build_information.h"
#include "shapegauge/experiments/results/sha256.h"

namespace shapegauge {

namespace {

using Json = nlohmann::ordered_json;

Json inputs(const ExperimentResults& results) {
  std::vector<std::string> hashes(results.models.size());
  tbb::parallel_for(std::size_t{0}, hashes.size(),
                    [&](std::size_t i) { hashes[i] = sha256_of_file(results.models[i].file); });
  Json models = Json::object();
  for (std::size_t i = 0; i < hashes.size(); ++i) models[results.models[i].id] = hashes[i];
  Json json{{"algorithm", "SHA-256"}, {"models", std::move(models)}};
  const auto& location = results.configuration.location;
  if (location && !location->classification.empty()) json["classification"] = sha256_of_file(location->classification);
  return json;
}

Json fields(const ExperimentResults& results) {
  Json list = Json::array();
  for (const FieldReport& field : results.fields)
    list.push_back({{"field", field.settings}, {"samples", field.outcomes}});
  return list;
}

Json failures(const ExperimentResults& results) {
  Json list = Json::array();
  for (const FailedModel& failure : results.failures) {
    list.push_back({{"model", failure.model.id}, {"error", failure.message}});
  }
  return list;
}

Json left_out(const ExperimentResults& results) {
  const bool none = results.methods.empty() || results.methods.front().evaluations.empty();
  return none ? Json(0) : Json(results.methods.front().evaluations.front().models_left_out);
}

Json execution(const ExperimentResults& results) {
  Json seconds = Json::object();
  for (const auto& [stage, time] : results.timings) seconds[stage] = time;
  Json by_field = Json::array();
  for (const FieldReport& field : results.fields) {
    by_field.push_back({{"field", field.settings}, {"seconds", field.seconds}});
  }
  return {{"threads", results.threads}, {"seconds", std::move(seconds)}, {"field_seconds", std::move(by_field)}};
}

}  // namespace

Json manifest(const ExperimentResults& results, const std::vector<std::string>& files) {
  return {{"shapegauge", version()},
          {"commit", commit()},
          {"compiler", compiler()},
          {"build_type", build_type()},
          {"libraries", Json::parse(library_versions())},
          {"configuration", to_json(results.configuration)},
          {"seed", results.configuration.seed},
          {"inputs", inputs(results)},
          {"models", results.models.size()},
          {"models_never_queries", left_out(results)},
          {"failed_models", failures(results)},
          {"fields", fields(results)},
          {"files", files},
          {"execution", execution(results)}};
}

}  // namespace shapegauge
