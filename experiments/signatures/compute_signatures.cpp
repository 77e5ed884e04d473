// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/compute_signatures.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <mutex>
#include <tbb/task_arena.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/describe_learnt.h"
#include "shapegauge/experiments/signatures/signature_tables.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

namespace {

/// Results for each model: descriptions and failures.
struct Described {
  DescribedModels models;
  std::vector<ModelFailure> failures;
  std::vector<LearntFeatures> learnt;              ///< per signature
  std::vector<std::vector<ModelFailure>> without;  ///< per signature: the models without it
};

[[noreturn]] void stop_for(const Dataset& dataset, const std::vector<ModelFailure>& failures, OnError on_error) {
  const ModelFailure& first = failures.front();
  const std::string& id = dataset.models[first.model].id;
  if (on_error == OnError::skip) {
    throw InputError(
        fmt::format("none of {} models can be used; the first is {}: {}", failures.size(), id, first.message));
  }
  const std::string others = failures.size() > 1 ? fmt::format(" (and {} more like it)", failures.size() - 1) : "";
  throw InputError(
      fmt::format(R"(model {}: {}{}; repair or remove it, or set "on_error" to "skip")", id, first.message, others));
}

void stop_on_failures(const Dataset& dataset, const std::vector<ModelFailure>& failures, OnError on_error) {
  const bool none_left = failures.size() == dataset.models.size();
  if (!failures.empty() && (none_left || on_error == OnError::stop)) {
    stop_for(dataset, failures, on_error);
  }
}

/// Returns the models that are not among the failures.
std::vector<std::size_t> models_without(const std::vector<ModelFailure>& failures, std::size_t count) {
  std::vector<std::size_t> models;
  auto failure = failures.begin();
  for (std::size_t i = 0; i < count; ++i) {
    if (failure != failures.end() && failure->model == i) {
      ++failure;
    } else {
      models.push_back(i);
    }
  }
  return models;
}

/// Returns the models without any signature.
std::vector<ModelFailure> without_signatures(const DescribedModels& models,
                                             const std::vector<SignatureConfiguration>& signatures,
                                             std::span<const Field> fields) {
  std::vector<ModelFailure> failures;
  for (const auto& [index, model] : models) {
    const std::vector<std::string> errors = signature_errors(model, signatures, fields);
    if (std::ranges::none_of(errors, &std::string::empty)) failures.push_back({index, errors.front()});
  }
  return failures;
}

/// Finds the models without each signature; throws if none has one of them.
void check_signatures_exist(const Dataset& dataset, const std::vector<SignatureConfiguration>& signatures,
                            Described& described, std::span<const Field> fields) {
  described.without.assign(signatures.size(), {});
  for (const auto& [index, model] : described.models) {
    std::vector<std::string> errors = signature_errors(model, signatures, fields);
    for (std::size_t i = 0; i < signatures.size(); ++i) {
      if (!errors[i].empty()) described.without[i].push_back({index, std::move(errors[i])});
    }
  }
  const std::size_t models = dataset.models.size() - described.failures.size();
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    const std::vector<ModelFailure>& all = described.without[i];
    if (all.size() < models) continue;
    throw InputError(fmt::format("signature \"{}\": none of {} models can be used; the first is {}: {}",
                                 signatures[i].name, models, dataset.models[all.front().model].id,
                                 all.front().message));
  }
}

/// Describes these models through the cache and passes the descriptions to `keep`, which is called by one thread at a
/// time. Returns the failures.
std::vector<ModelFailure> describe_each(const Dataset& dataset, const std::vector<std::size_t>& models,
                                        const Configuration& configuration, std::span<const Field> fields,
                                        const RunContext& context,
                                        const std::function<void(std::size_t, ModelDescription)>& keep) {
  // Processing shapes in parallel needs no synchronisation, but a few shapes do not occupy all threads.
  const bool parallel_within = models.size() < 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  std::mutex mutex;
  return for_each_model(models, "signatures", configuration.on_error == OnError::stop, context.control,
                        [&](std::size_t model) {
                          ModelDescription description =
                              describe_model(dataset, model, configuration, fields, parallel_within, context.cache);
                          const std::scoped_lock lock(mutex);
                          keep(model, std::move(description));
                        });
}

Described describe_models(const Dataset& dataset, const Configuration& configuration, std::span<const Field> fields,
                          const RunContext& context) {
  Described described;
  described.failures = check_models(dataset);
  stop_on_failures(dataset, described.failures, configuration.on_error);
  const auto add = [&](std::vector<ModelFailure> more) {
    described.failures.insert(described.failures.end(), more.begin(), more.end());
    std::ranges::sort(described.failures, {}, &ModelFailure::model);
    stop_on_failures(dataset, described.failures, configuration.on_error);
  };
  add(describe_each(dataset, models_without(described.failures, dataset.models.size()), configuration, fields, context,
                    [&](std::size_t model, ModelDescription description) {
                      described.models.emplace(model, std::move(description));
                    }));
  check_signatures_exist(dataset, configuration.signatures, described, fields);
  add(describe_learnt(described.models, configuration, fields, context, described.learnt));
  const std::vector<ModelFailure> useless = without_signatures(described.models, configuration.signatures, fields);
  for (const ModelFailure& failure : useless) described.models.erase(failure.model);
  add(useless);
  check_signatures_exist(dataset, configuration.signatures, described, fields);
  return described;
}

/// Returns the fields of the views, with the scales of pictures and histograms.
std::vector<ViewedField> viewed_fields_of(const ComputedSignatures& computed, std::span<const Field> fields,
                                          const Configuration& configuration) {
  std::vector<ViewedField> viewed;
  for (const std::size_t i : viewed_fields(fields, configuration)) {
    const bool pictured = is_pictured(fields[i], configuration);
    const std::size_t signature = pictured ? configuration.report.pictured_signature
                                           : first_histogram_of(fields[i], configuration.signatures).value();
    ViewedField& field =
        viewed.emplace_back(ViewedField{.name = configuration.signatures[signature].name, .colours = {}});
    if (fields[i].dimension == FieldDimension::length) field.measured_by = measured_by(fields[i].settings.type);
    if (pictured)
      field.colours = configuration.report.picture_options.range;
    else if (configuration.signatures[signature].histogram.range != HistogramRange::per_shape) {
      field.colours = computed.histogram_ranges[signature].front();
    }
  }
  return viewed;
}

/// Adds the reports on models to the results.
void report(std::vector<ModelDescription*> models, const Configuration& configuration, std::span<const Field> fields,
            ComputedSignatures& computed) {
  const std::vector<const ModelDescription*> all(models.begin(), models.end());
  computed.histogram_ranges.resize(configuration.signatures.size());
  for (std::size_t i = 0; i < configuration.signatures.size(); ++i) {
    const SignatureConfiguration& signature = configuration.signatures[i];
    if (!signature.field) continue;
    computed.histogram_ranges[i] = histogram_ranges(all, signature.histogram, index_of(fields, *signature.field));
  }
  computed.fields = report_fields(all, fields);
  for (ModelDescription* const model : models) {
    computed.pictures.push_back(std::move(model->picture));
    computed.views.push_back(std::move(model->view));
    computed.shapes.push_back(without_values(std::move(*model)));
  }
  for (std::vector<std::string>* drawings : {&computed.pictures, &computed.views}) {
    if (std::ranges::all_of(*drawings, &std::string::empty)) drawings->clear();
  }
  if (!computed.views.empty()) computed.viewed = viewed_fields_of(computed, fields, configuration);
}

}  // namespace

ComputedSignatures compute_signatures(const Dataset& dataset, const Configuration& configuration,
                                      const RunContext& context) {
  const std::vector<Field> fields = distinct_fields(configuration.signatures);
  Described described = describe_models(dataset, configuration, fields, context);
  ComputedSignatures computed;
  computed.models = models_without(described.failures, dataset.models.size());
  computed.failures = std::move(described.failures);
  computed.without = std::move(described.without);
  for (std::vector<ModelFailure>& failures : computed.without) {
    for (ModelFailure& failure : failures) {
      const auto found = std::ranges::lower_bound(computed.models, failure.model);
      failure.model = static_cast<std::size_t>(found - computed.models.begin());
    }
  }
  std::vector<ModelDescription*> models;
  for (auto& [index, model] : described.models) models.push_back(&model);
  const std::vector<const ModelDescription*> all(models.begin(), models.end());
  computed.field_ranges = field_ranges(all, fields.size());
  computed.signatures = assemble_signatures(all, fields, configuration.signatures, computed.field_ranges);
  computed.learnt = std::move(described.learnt);
  report(std::move(models), configuration, fields, computed);
  return computed;
}

PartOutcome describe_part(const Dataset& dataset, const Configuration& configuration, const RunContext& context,
                          const Part& part) {
  const std::vector<Field> fields = distinct_fields(configuration.signatures);
  std::vector<ModelFailure> failures = check_models(dataset);
  stop_on_failures(dataset, failures, configuration.on_error);
  const std::vector<std::size_t> shard = part.of(models_without(failures, dataset.models.size()));
  std::vector<std::size_t> incomplete;
  failures = describe_each(dataset, shard, configuration, fields, context,
                           [&](std::size_t model, const ModelDescription& description) {
                             const auto errors = signature_errors(description, configuration.signatures, fields);
                             if (!std::ranges::all_of(errors, &std::string::empty)) incomplete.push_back(model);
                           });
  stop_on_failures(dataset, failures, configuration.on_error);
  for (const ModelFailure& failure : failures) incomplete.push_back(failure.model);
  for (const std::size_t model : incomplete) note_failure(dataset, model, configuration, fields, context.cache);
  PartOutcome outcome{.shapes = shard.size() - failures.size(), .all = dataset.models.size()};
  for (const ModelFailure& failure : failures) {
    const Model& model = dataset.models[failure.model];
    outcome.left_out.push_back({.id = model.id, .message = failure.message, .file = model.file});
  }
  return outcome;
}

bool are_all_described(const Dataset& dataset, const Configuration& configuration, const RunContext& context) {
  const std::vector<Field> fields = distinct_fields(configuration.signatures);
  std::vector<std::size_t> models = models_without(check_models(dataset), dataset.models.size());
  std::ranges::reverse(models);  // the last shapes are described last
  return for_each_model(models, "shapes of other parts", true, context.control,
                        [&](std::size_t model) {
                          if (!is_described(dataset, model, configuration, fields, context.cache))
                            throw InputError("missing");
                        })
      .empty();
}

}  // namespace shapegauge
