#include "shapegauge/experiments/runner/compute_signatures.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <tbb/task_arena.h>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/runner/assemble_signatures.h"
#include "shapegauge/experiments/runner/describe_model.h"
#include "shapegauge/experiments/runner/describe_through_cache.h"
#include "shapegauge/experiments/runner/for_each_model.h"

namespace shapegauge {

namespace {

/// What became of each model.
struct Described {
  std::vector<std::optional<ModelDescription>> models;
  std::vector<ModelFailure> failures;
};

[[noreturn]] void stop_for(const Dataset& dataset, const std::vector<ModelFailure>& failures) {
  const ModelFailure& first = failures.front();
  const std::string others = failures.size() > 1 ? fmt::format(" (and {} more like it)", failures.size() - 1) : "";
  throw InputError(fmt::format(R"(model {}: {}{}; repair or remove it, or set "on_error" to "skip")",
                               dataset.models[first.model].id, first.message, others));
}

void stop_if_told(const Dataset& dataset, const std::vector<ModelFailure>& failures, OnError on_error) {
  const bool none_left = failures.size() == dataset.models.size();
  if (!failures.empty() && (none_left || on_error == OnError::stop)) stop_for(dataset, failures);
}

Described describe_models(const Dataset& dataset, const Configuration& configuration, const RunControl& control,
                          std::span<const PlannedField> plan, Cache& cache) {
  Described described;
  described.models.resize(dataset.models.size());
  described.failures = check_models(dataset);
  stop_if_told(dataset, described.failures, configuration.on_error);
  std::vector<std::size_t> remaining;
  for (std::size_t i = 0; i < dataset.models.size(); ++i) {
    if (std::ranges::find(described.failures, i, &ModelFailure::model) == described.failures.end())
      remaining.push_back(i);
  }
  // Shapes one beside the other need no synchronisation; only few of them are too little work for the threads.
  const bool parallel_within = remaining.size() < 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::vector<ModelFailure> failures =
      for_each_model(remaining, "signatures", configuration.on_error == OnError::stop, control, [&](std::size_t model) {
        described.models[model] = describe_through_cache(dataset, model, configuration, plan, parallel_within, cache);
      });
  described.failures.insert(described.failures.end(), failures.begin(), failures.end());
  std::ranges::sort(described.failures, {}, &ModelFailure::model);
  stop_if_told(dataset, described.failures, configuration.on_error);
  return described;
}

}  // namespace

ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunControl& control, Cache& cache) {
  const std::vector<PlannedField> plan = plan_fields(configuration.signatures);
  Described described = describe_models(dataset, configuration, control, plan, cache);
  ComputedSignatures computed;
  std::vector<const ModelDescription*> models;
  for (std::size_t i = 0; i < described.models.size(); ++i) {
    if (!described.models[i]) continue;
    computed.models.push_back(i);
    models.push_back(&*described.models[i]);
    computed.shapes.push_back(report_shape(*described.models[i]));
  }
  computed.signatures = assemble_signatures(models, plan, configuration.signatures);
  computed.fields = report_fields(models, plan);
  computed.failures = std::move(described.failures);
  return computed;
}

}  // namespace shapegauge
