#include "shapegauge/experiments/runner/compute_signatures.h"

#include <algorithm>
#include <fmt/format.h>
#include <mutex>
#include <optional>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/runner/describe_model.h"
#include "shapegauge/retrieval/signature.h"

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
  throw InputError(fmt::format("model {}: {}{}; repair or remove it, or set \"on_error\" to \"skip\"",
                               dataset.models[first.model].id, first.message, others));
}

/// Describes every model that has not failed yet.
class ModelJobs {
 public:
  ModelJobs(const Dataset& dataset, const Configuration& configuration, const RunControl& control,
            std::span<const PlannedField> plan)
      : dataset_(dataset), configuration_(configuration), control_(control), plan_(plan) {}

  Described run() {
    described_.models.resize(dataset_.models.size());
    described_.failures = check_models(dataset_);
    stop_if_told();
    std::vector<std::size_t> todo;
    for (std::size_t i = 0; i < dataset_.models.size(); ++i) {
      if (std::ranges::find(described_.failures, i, &ModelFailure::model) == described_.failures.end())
        todo.push_back(i);
    }
    // Shapes one beside the other need no synchronisation; only few of them are too little work for the threads.
    const bool parallel_within = todo.size() < 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    control_.progress("signatures", 0, todo.size());
    tbb::task_group_context group;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, todo.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) {
            if (control_.interrupted()) group.cancel_group_execution();
            if (group.is_group_execution_cancelled()) return;
            describe(todo[i], parallel_within, group);
            const std::scoped_lock lock(mutex_);
            control_.progress("signatures", ++done_, todo.size());
          }
        },
        tbb::simple_partitioner(), group);
    if (control_.interrupted()) throw Interrupted();
    std::ranges::sort(described_.failures, {}, &ModelFailure::model);
    stop_if_told();
    return std::move(described_);
  }

 private:
  void describe(std::size_t model, bool parallel_within, tbb::task_group_context& group) {
    try {
      // Isolated: a thread that waits for its own shape's samples must not begin another shape meanwhile.
      tbb::this_task_arena::isolate([&] {
        described_.models[model] =
            describe_model(dataset_.models[model], plan_, configuration_.signatures, parallel_within);
      });
    } catch (const std::exception& error) {
      const std::scoped_lock lock(mutex_);
      described_.failures.push_back({.model = model, .message = error.what()});
      if (configuration_.on_error == OnError::stop) group.cancel_group_execution();
    }
  }

  void stop_if_told() const {
    const bool all = described_.failures.size() == dataset_.models.size();
    if (!described_.failures.empty() && (all || configuration_.on_error == OnError::stop)) {
      stop_for(dataset_, described_.failures);
    }
  }

  const Dataset& dataset_;
  const Configuration& configuration_;
  const RunControl& control_;
  std::span<const PlannedField> plan_;
  Described described_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

/// The union of the ranges of a field over all models.
Interval common_range(const std::vector<const ModelDescription*>& models, std::size_t field) {
  std::vector<Interval> ranges;
  for (const ModelDescription* model : models) ranges.push_back(model->fields[field].range);
  return enclosing_interval(ranges);
}

/// One signature, a histogram, of all models.
Signatures histograms_of(const std::vector<const ModelDescription*>& models, const HistogramConfiguration& wanted,
                         std::size_t signature, std::size_t field) {
  Signatures table(static_cast<Eigen::Index>(models.size()), wanted.options.bins);
  const bool of_dataset = wanted.range == HistogramRange::dataset;
  const Interval range = of_dataset ? common_range(models, field) : Interval{};
  tbb::parallel_for(std::size_t{0}, models.size(), [&](std::size_t i) {
    table.row(static_cast<Eigen::Index>(i)) =
        of_dataset ? kept_histogram(models[i]->fields[field], range, wanted.options) : models[i]->histograms[signature];
  });
  return table;
}

std::vector<Signatures> assemble(const std::vector<const ModelDescription*>& models, std::span<const PlannedField> plan,
                                 const std::vector<SignatureConfiguration>& signatures) {
  std::vector<Signatures> tables(signatures.size());
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) {
      tables[i] = histograms_of(models, signatures[i].histogram, i, field);
    }
  }
  for (const std::size_t i : computation_order(signatures)) {
    if (signatures[i].field) continue;
    std::vector<Signatures> parts;
    for (const std::size_t part : signatures[i].parts) parts.push_back(tables[part]);
    tables[i] = concatenate(parts);
  }
  return tables;
}

std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const PlannedField> plan) {
  std::vector<FieldReport> reports;
  for (std::size_t field = 0; field < plan.size(); ++field) {
    FieldReport& report = reports.emplace_back();
    report.settings = plan[field].field.settings;
    for (const ModelDescription* model : models) {
      report.seconds += model->fields[field].seconds;
      for (const auto& [outcome, count] : model->fields[field].outcomes) report.outcomes[outcome] += count;
    }
  }
  return reports;
}

}  // namespace

ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunControl& control) {
  const std::vector<PlannedField> plan = plan_fields(configuration.signatures);
  Described described = ModelJobs(dataset, configuration, control, plan).run();
  ComputedSignatures computed;
  std::vector<const ModelDescription*> models;
  for (std::size_t i = 0; i < described.models.size(); ++i) {
    if (!described.models[i]) continue;
    computed.models.push_back(i);
    models.push_back(&*described.models[i]);
  }
  computed.signatures = assemble(models, plan, configuration.signatures);
  computed.fields = report_fields(models, plan);
  computed.failures = std::move(described.failures);
  return computed;
}

}  // namespace shapegauge
