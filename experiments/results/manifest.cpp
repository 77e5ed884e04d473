#include "shapegauge/experiments/results/manifest.h"

#include <tbb/parallel_for.h>

#include "shapegauge/experiments/results/manifest_parts.h"
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

}  // namespace

Json manifest(const ExperimentResults& results, const std::vector<std::string>& files) {
  Json json = program_json();
  json.update({{"configuration", to_json(results.configuration)},
               {"seed", results.configuration.seed},
               {"inputs", inputs(results)},
               {"models", results.models.size()},
               {"models_never_queries", left_out(results)},
               {"failed_models", failures(results)},
               {"fields", fields_json(results.fields)},
               {"files", files},
               {"execution", execution_json(results.threads, results.timings, results.fields)}});
  return json;
}

}  // namespace shapegauge
