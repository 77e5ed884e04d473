#include "shapegauge/experiments/runner/compute_signatures.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/runner/describe_learnt.h"
#include "shapegauge/experiments/runner/describe_model.h"
#include "shapegauge/experiments/runner/describe_through_cache.h"
#include "shapegauge/experiments/runner/run_control.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

namespace {

/// The union of the ranges of a field over all models.
Interval common_range(const std::vector<const ModelDescription*>& models, std::size_t field) {
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
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
  const auto add = [&](const std::vector<ModelFailure>& more) {
    described.failures.insert(described.failures.end(), more.begin(), more.end());
    std::ranges::sort(described.failures, {}, &ModelFailure::model);
    stop_if_told(dataset, described.failures, configuration.on_error);
  };
  add(failures);
  for (;;) {
    const std::vector<ModelFailure> more = describe_learnt(described.models, configuration, plan, control, cache);
    if (more.empty()) return described;
    for (const ModelFailure& failure : more) described.models[failure.model].reset();
    add(more);
  }
}

/// The features of one descriptor of all models.
Signatures features_of(const std::vector<const ModelDescription*>& models, std::size_t descriptor) {
  const Eigen::Index length = models.front()->features[descriptor].features.size();
  Signatures table(std::ssize(models), length);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Eigen::VectorXf& features = models[i]->features[descriptor].features;
    if (features.size() != length) {
      throw std::invalid_argument(
          fmt::format("a descriptor gives {} features of one model, {} of another", length, features.size()));
    }
    table.row(static_cast<Eigen::Index>(i)) = features.transpose();
  }
  return table;
}

}  // namespace

std::vector<Signatures> assemble_signatures(const std::vector<const ModelDescription*>& models,
                                            std::span<const PlannedField> plan,
                                            const std::vector<SignatureConfiguration>& signatures) {
  std::vector<Signatures> tables(signatures.size());
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) {
      tables[i] = histograms_of(models, signatures[i].histogram, i, field);
    }
  }
  const std::vector<PlannedDescriptor> descriptors = plan_descriptors(signatures, plan);
  for (std::size_t d = 0; d < descriptors.size(); ++d) tables[descriptors[d].signature] = features_of(models, d);
  for (const std::size_t i : computation_order(signatures)) {
    if (signatures[i].field || signatures[i].descriptor || signatures[i].derived) continue;
    std::vector<Signatures> parts;
    for (const std::size_t part : signatures[i].parts) parts.push_back(tables[part]);
    tables[i] = concatenate(parts);
  }
  return tables;
}

namespace {

/// Whether the model's gaps are wider than the offset of a field on it. Fields without an offset do not leak.
bool leaks(const ShapeDiagnostics& model, const FieldDescription& found, const nlohmann::json& settings) {
  const auto given = settings.find("offset");
  if (given == settings.end()) return false;
  return model.gap_size > (found.offset ? *found.offset : given->get<double>()) * model.diagonal;
}

}  // namespace

std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const PlannedField> plan) {
  std::vector<FieldReport> reports;
  for (std::size_t field = 0; field < plan.size(); ++field) {
    FieldReport& report = reports.emplace_back();
    report.settings = plan[field].field.settings;
    report.models = models.size();
    for (const ModelDescription* model : models) {
      report.seconds += model->fields[field].seconds;
      if (leaks(model->diagnostics, model->fields[field], report.settings)) ++report.leaking;
      for (const auto& [outcome, count] : model->fields[field].outcomes) report.outcomes[outcome] += count;
    }
  }
  return reports;
}

ShapeReport report_shape(const ModelDescription& model) {
  ShapeReport report{.sha256 = model.sha256,
                     .diagnostics = model.diagnostics,
                     .chosen = model.chosen,
                     .area = model.area,
                     .noise = model.noise,
                     .pass_band = model.pass_band,
                     .outcomes = {},
                     .offsets = {},
                     .seconds = {},
                     .descriptor_seconds = {}};
  for (const FieldDescription& field : model.fields) {
    report.outcomes.push_back(field.outcomes);
    report.offsets.push_back(field.offset);
    report.seconds.push_back(field.seconds);
  }
  for (const FeatureDescription& descriptor : model.features) report.descriptor_seconds.push_back(descriptor.seconds);
  return report;
}

std::vector<Interval> histogram_ranges(const std::vector<const ModelDescription*>& models,
                                       const HistogramConfiguration& wanted, std::size_t field) {
  if (wanted.range == HistogramRange::fixed) return std::vector(models.size(), wanted.fixed);
  if (wanted.range == HistogramRange::dataset) return std::vector(models.size(), common_range(models, field));
  std::vector<Interval> ranges;
  ranges.reserve(models.size());
  for (const ModelDescription* model : models) ranges.push_back(model->fields[field].range);
  return ranges;
}

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
    if (!described.models[i]->picture.empty()) computed.pictures.push_back(described.models[i]->picture);
  }
  computed.signatures = assemble_signatures(models, plan, configuration.signatures);
  computed.histogram_ranges.resize(configuration.signatures.size());
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) {
      computed.histogram_ranges[i] = histogram_ranges(models, configuration.signatures[i].histogram, field);
    }
  }
  computed.fields = report_fields(models, plan);
  computed.failures = std::move(described.failures);
  return computed;
}

std::vector<std::string> field_warnings(std::span<const FieldReport> fields) {
  std::vector<std::string> warnings;
  for (const FieldReport& field : fields) {
    if (field.leaking > 0) {
      warnings.push_back(fmt::format(
          R"({} of {} shapes have gaps wider than the offset of the field {}: the offset surface leaks into them; )"
          R"(use a larger offset or "auto")",
          field.leaking, field.models, field.settings.dump()));
    }
    for (const std::string& warning : outcome_warnings(field.outcomes)) {
      warnings.push_back(fmt::format("{} in the field {}", warning, field.settings.dump()));
    }
  }
  return warnings;
}

}  // namespace shapegauge
