// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/retrieval/manifest_entries.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/experiments/signatures/cache_keys.h"
#include "shapegauge/experiments/signatures/shape_reports.h"

namespace shapegauge {

using OrderedJson = nlohmann::ordered_json;

namespace {

std::vector<std::string> ids_of(const std::vector<Model>& models) {
  std::vector<std::string> ids;
  for (const Model& model : models) ids.push_back(model.id);
  return ids;
}

/// Returns the inputs with the models' hashes, omitting empty ones.
OrderedJson inputs_json(const Configuration& configuration, const std::vector<std::string>& ids,
                        const std::vector<std::string>& hashes) {
  OrderedJson by_model = OrderedJson::object();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!hashes[i].empty()) by_model[ids[i]] = hashes[i];
  }
  OrderedJson json{{"algorithm", "SHA-256"}, {"models", std::move(by_model)}};
  const auto& location = configuration.location;
  if (location && !location->classification.empty()) json["classification"] = sha256_of_file(location->classification);
  return json;
}

/// Returns the hashes of the used and of the failed models.
OrderedJson inputs(const ExperimentResults& results) {
  std::vector<std::string> ids = ids_of(results.models);
  std::vector<std::string> hashes;
  for (const ModelDescription& shape : results.shapes) hashes.push_back(shape.sha256);
  for (const LeftOutShape& failure : results.failures) {
    ids.push_back(failure.id);
    hashes.push_back(sha256_if_readable(failure.file));
  }
  return inputs_json(results.configuration, ids, hashes);
}

/// Returns the models that some method cannot process, although another can.
OrderedJson method_failures(const ExperimentResults& results) {
  OrderedJson list = OrderedJson::array();
  for (const MethodResults& method : results.methods) {
    for (const ModelFailure& failure : method.failures) {
      list.push_back(
          {{"method", method.name}, {"model", results.models[failure.model].id}, {"error", failure.message}});
    }
  }
  return list;
}

OrderedJson left_out(const ExperimentResults& results) {
  const bool none = results.methods.empty() || results.methods.front().evaluations.empty();
  return none ? OrderedJson(0) : OrderedJson(results.methods.front().evaluations.front().excluded_models);
}

}  // namespace

OrderedJson dataset_inputs(const Configuration& configuration, const std::vector<Model>& models) {
  std::vector<std::string> hashes(models.size());
  parallel_for(std::size_t{0}, hashes.size(), [&](std::size_t i) { hashes[i] = sha256_if_readable(models[i].file); });
  return inputs_json(configuration, ids_of(models), hashes);
}

OrderedJson manifest_entries(const ExperimentResults& results) {
  return {{"seed", results.configuration.seed},
          {"inputs", inputs(results)},
          {"models", results.models.size()},
          {"models_never_queries", left_out(results)},
          {"failed_models", failures_json(results.failures)},
          {"method_failures", method_failures(results)},
          {"fields", fields_json(results.fields)}};
}

}  // namespace shapegauge
