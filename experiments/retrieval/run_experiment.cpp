// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/retrieval/run_experiment.h"

#include <utility>

#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/engine/generated_dataset.h"
#include "shapegauge/experiments/retrieval/run_methods.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// Finds or generates the data set of the configuration; a generated one goes into the given folder.
Dataset prepare_dataset(const Configuration& configuration, const RunContext& context) {
  if (!configuration.generator) return find_dataset(configuration.location.value());
  const fs::path& folder = context.generated;
  prepare_generated(folder, *configuration.generator, context.control);
  return find_dataset({.layout = "shrec11", .root = folder, .classification = folder / "test.cla"});
}

/// Returns the models with signatures.
std::vector<Model> models_of(const Dataset& dataset, const ComputedSignatures& computed) {
  std::vector<Model> models;
  for (const std::size_t model : computed.models) models.push_back(dataset.models[model]);
  return models;
}

void run_stages(const Configuration& configuration, const RunContext& context,
                const std::vector<fs::path>& distance_files, ExperimentResults& results) {
  Stopwatch stopwatch;
  const Dataset dataset = prepare_dataset(configuration, context);
  check_queries(dataset.models, configuration.evaluation);
  results.timings.emplace_back("dataset", stopwatch.lap());

  ComputedSignatures computed = compute_signatures(dataset, configuration, context);
  results.classes = dataset.classes;
  results.skipped = dataset.skipped;
  results.models = models_of(dataset, computed);
  for (const ModelFailure& failure : computed.failures) {
    const Model& model = dataset.models[failure.model];
    results.failures.push_back({.id = model.id, .message = failure.message, .file = model.file});
  }
  static_cast<DescribedShapes&>(results) = static_cast<DescribedShapes&&>(computed);
  results.timings.emplace_back("signatures", stopwatch.lap());

  run_methods(configuration, distance_files, context, computed, results);
}

}  // namespace

ExperimentResults run_experiment(const Configuration& configuration, const RunContext& context,
                                 const std::vector<fs::path>& distance_files) {
  ExperimentResults results;
  results.configuration = configuration;
  results.threads = thread_count(context.control);
  with_threads(context.control, [&] { run_stages(configuration, context, distance_files, results); });
  results.cache = context.cache.report();
  return results;
}

ExperimentResults run_experiment(const Configuration& configuration, const fs::path& generated_folder,
                                 const RunControl& control) {
  Cache none;
  return run_experiment(configuration, {.control = control, .cache = none, .generated = generated_folder}, {});
}

PartOutcome run_part_of_experiment(const Configuration& configuration, const RunContext& context, const Part& part) {
  PartOutcome outcome;
  with_threads(context.control, [&] {
    const Dataset dataset = prepare_dataset(configuration, context);
    check_queries(dataset.models, configuration.evaluation);
    outcome = describe_part(dataset, configuration, context, part);
    if (!has_streamed_methods(configuration, dataset.models.size())) return;
    if (!are_all_described(dataset, configuration, context)) return;
    const ComputedSignatures computed = compute_signatures(dataset, configuration, context);
    outcome.rows = evaluate_part_of_rows(configuration, context, models_of(dataset, computed), computed, part);
  });
  return outcome;
}

}  // namespace shapegauge
