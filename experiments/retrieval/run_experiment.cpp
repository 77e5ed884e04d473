#include "shapegauge/experiments/retrieval/run_experiment.h"

#include <utility>

#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/engine/generated_dataset.h"
#include "shapegauge/experiments/retrieval/run_methods.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// Finds or generates the data set of the configuration; a generated one goes into the given folder. Collective.
Dataset prepare_dataset(const Configuration& configuration, const fs::path& generated_folder, const RunControl& control,
                        Communicator& ranks) {
  if (configuration.generator) prepare_generated(generated_folder, *configuration.generator, control, ranks);
  return on_all_ranks(ranks, [&] {
    if (!configuration.generator) return find_dataset(configuration.location.value());
    return find_dataset(
        {.layout = "shrec11", .root = generated_folder, .classification = generated_folder / "test.cla"});
  });
}

void run_stages(const Configuration& configuration, const RunContext& context,
                const std::vector<fs::path>& distance_files, ExperimentResults& results) {
  Stopwatch stopwatch;
  const Dataset dataset = prepare_dataset(configuration, context.generated, context.control, context.ranks);
  results.timings.emplace_back("dataset", stopwatch.lap());

  ComputedSignatures computed = compute_signatures(dataset, configuration, context);
  results.classes = dataset.classes;
  results.skipped = dataset.skipped;
  for (const std::size_t model : computed.models) results.models.push_back(dataset.models[model]);
  for (const ModelFailure& failure : computed.failures) {
    const Model& model = dataset.models[failure.model];
    results.failures.push_back({.id = model.id, .message = failure.message, .file = model.file});
  }
  results.fields = std::move(computed.fields);
  results.shapes = std::move(computed.shapes);
  results.pictures = std::move(computed.pictures);
  results.views = std::move(computed.views);
  results.viewed = std::move(computed.viewed);
  results.timings.emplace_back("signatures", stopwatch.lap());

  run_methods(configuration, distance_files, context, computed, results);
}

}  // namespace

ExperimentResults run_experiment(const Configuration& configuration, const RunContext& context,
                                 const std::vector<fs::path>& distance_files) {
  ExperimentResults results;
  results.processes = context.ranks.size();
  results.configuration = configuration;
  results.threads = thread_count(context.control);
  with_threads(context.control, [&] { run_stages(configuration, context, distance_files, results); });
  results.cache = cache_report(context.cache, context.ranks);
  return results;
}

ExperimentResults run_experiment(const Configuration& configuration, const fs::path& generated_folder,
                                 const RunControl& control) {
  Cache none;
  const auto ranks = single_process();
  return run_experiment(configuration,
                        {.control = control, .cache = none, .ranks = *ranks, .generated = generated_folder}, {});
}

}  // namespace shapegauge
