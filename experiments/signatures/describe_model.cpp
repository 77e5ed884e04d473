#include "shapegauge/experiments/signatures/describe_model.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/signatures/cache_keys.h"
#include "shapegauge/experiments/signatures/model_view.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

namespace {

/// Returns the index of the field in the plan; the plan's size if missing.
std::size_t place_in(std::span<const PlannedField> plan, const Field& field) {
  const auto same = [&](const PlannedField& known) { return known.field.settings == field.settings; };
  return static_cast<std::size_t>(std::ranges::find_if(plan, same) - plan.begin());
}

/// Returns the plan's entry for the field, adding it if it is new.
PlannedField& planned(std::vector<PlannedField>& plan, const Field& field) {
  const std::size_t place = place_in(plan, field);
  if (place == plan.size()) plan.push_back({.field = field, .signatures = {}});
  return plan[place];
}

}  // namespace

std::vector<PlannedField> plan_fields(const std::vector<SignatureConfiguration>& signatures) {
  std::vector<PlannedField> plan;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    const SignatureConfiguration& signature = signatures[i];
    if (signature.field) {
      PlannedField& field = planned(plan, *signature.field);
      field.signatures.push_back(i);
      if (signature.histogram.range == HistogramRange::dataset) field.keep_values = true;
    } else if (signature.descriptor) {
      const DescriptorChoice& choice = *signature.descriptor;
      for (const Field& of_descriptor : choice.fields) {
        PlannedField& field = planned(plan, of_descriptor);
        if (needs_learning(choice.descriptor, choice.values)) field.keep_values = true;
      }
    }
  }
  return plan;
}

std::vector<PlannedDescriptor> plan_descriptors(const std::vector<SignatureConfiguration>& signatures,
                                                std::span<const PlannedField> plan) {
  std::vector<PlannedDescriptor> descriptors;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    if (!signatures[i].descriptor) continue;
    const DescriptorChoice& choice = *signatures[i].descriptor;
    PlannedDescriptor& added = descriptors.emplace_back();
    added.signature = i;
    added.learns = needs_learning(choice.descriptor, choice.values);
    for (const Field& field : choice.fields) added.fields.push_back(place_in(plan, field));
  }
  return descriptors;
}

std::vector<std::string> signature_errors(const ModelDescription& model,
                                          const std::vector<SignatureConfiguration>& signatures,
                                          std::span<const PlannedField> plan) {
  std::vector<std::string> errors(signatures.size());
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) errors[i] = model.fields[field].error;
  }
  const std::vector<PlannedDescriptor> descriptors = plan_descriptors(signatures, plan);
  for (std::size_t d = 0; d < model.features.size(); ++d) {
    std::string& error = errors[descriptors[d].signature];
    for (const std::size_t field : descriptors[d].fields) {
      if (error.empty()) error = model.fields[field].error;
    }
    if (error.empty()) error = model.features[d].error;
  }
  for (const std::size_t i : computation_order(signatures)) {
    for (const std::size_t part : signatures[i].parts) {
      if (errors[i].empty()) errors[i] = errors[part];
    }
  }
  return errors;
}

bool is_pictured(const PlannedField& planned, const Configuration& configuration) {
  const ReportConfiguration& report = configuration.report;
  if (!report.wanted || !report.pictures) return false;
  return planned.field.settings == pictured_field(configuration.signatures[report.pictured_signature])->settings;
}

std::vector<std::size_t> viewed_fields(std::span<const PlannedField> plan, const Configuration& configuration) {
  std::vector<std::size_t> fields;
  const ReportConfiguration& report = configuration.report;
  if (!report.wanted || !report.pictures || !report.views) return fields;
  for (const bool pictured : {true, false}) {
    for (std::size_t i = 0; i < plan.size(); ++i) {
      if (is_pictured(plan[i], configuration) != pictured || (!pictured && plan[i].signatures.empty())) continue;
      if (fields.size() < max_viewed_fields) fields.push_back(i);
    }
  }
  return fields;
}

FieldDescription describe_field(const StoredField& field, const Eigen::VectorXd& weights, const PlannedField& planned,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::vector<Eigen::VectorXf>& histograms) {
  FieldDescription description;
  description.range = field.range;
  description.outcomes = field.outcomes;
  description.offset = field.offset;
  description.seconds = field.seconds;
  for (const std::size_t i : planned.signatures) {
    const HistogramConfiguration& wanted = signatures[i].histogram;
    if (wanted.range == HistogramRange::dataset) continue;
    const Interval& range = wanted.range == HistogramRange::fixed ? wanted.fixed : field.range;
    histograms[i] = histogram({.values = field.values, .weights = weights}, range, wanted.options);
  }
  if (planned.keep_values) {
    description.values = field.values.cast<float>();
    description.weights = weights.cast<float>();
  }
  return description;
}

namespace {

/// Calls the work; with OnError::skip, returns the message of its InputError, otherwise nothing.
template <typename Work>
std::string error_of(OnError on_error, const Work& work) {
  try {
    work();
    return {};
  } catch (const InputError& error) {
    if (on_error == OnError::stop) throw;
    return error.what();
  }
}

FeatureDescription describe_descriptor(Bench& bench, const PlannedDescriptor& planned,
                                       const ModelDescription& description, const Configuration& configuration) {
  FeatureDescription features;
  if (planned.learns) return features;  // completed after all shapes
  for (const std::size_t field : planned.fields) {
    features.error = description.fields[field].error;
    if (!features.error.empty()) return features;
  }
  const DescriptorChoice& choice = *configuration.signatures[planned.signature].descriptor;
  const std::string error = error_of(configuration.on_error, [&] { features = bench.features(choice); });
  if (!error.empty()) features.error = error;
  return features;
}

/// Adds the picture and the view.
void draw(Bench& bench, const Configuration& configuration, std::span<const PlannedField> plan, Eigen::Index view_faces,
          ModelDescription& description) {
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (!is_pictured(plan[i], configuration) || !description.fields[i].error.empty()) continue;
    description.picture = bench.picture(plan[i].field, configuration.report.picture_options);
  }
  std::vector<Field> viewed;
  std::vector<bool> has_field;
  for (const std::size_t i : viewed_fields(plan, configuration)) {
    viewed.push_back(plan[i].field);
    has_field.push_back(description.fields[i].error.empty());
  }
  if (view_faces > 0 && !viewed.empty()) description.view = bench.view(viewed, has_field, view_faces);
}

}  // namespace

ModelDescription describe_shape(Bench& bench, const Configuration& configuration, std::span<const PlannedField> plan,
                                Eigen::Index view_faces) {
  ModelDescription description;
  static_cast<ShapeFacts&>(description) = bench.facts();
  description.shape_key = bench.key();
  description.histograms.resize(configuration.signatures.size());
  for (const PlannedField& planned : plan) {
    FieldDescription field;
    const std::string error = error_of(configuration.on_error, [&] {
      field = describe_field(bench.field(planned.field), bench.weights(planned.field.settings.samples), planned,
                             configuration.signatures, description.histograms);
    });
    if (!error.empty()) field.error = error;
    description.fields.push_back(std::move(field));
  }
  for (const PlannedDescriptor& planned : plan_descriptors(configuration.signatures, plan)) {
    description.features.push_back(describe_descriptor(bench, planned, description, configuration));
  }
  draw(bench, configuration, plan, view_faces, description);
  return description;
}

namespace {

/// A result is not in the cache.
struct NotStored {};

/// Describes a model; `read` returns the shape of its file.
ModelDescription describe_source(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                 std::span<const PlannedField> plan, bool parallel, Cache& cache,
                                 const std::function<Shape(const ShapeSource&)>& read) {
  const Model& source = dataset.models[model];
  const ShapeSource file = read_shape_source(source.file);
  const std::string hash = sha256_of_shape(file);
  const ModelSource depends_on{.sha256 = hash, .file = source.file, .id = source.id, .index = model};
  const auto perturbed = [&] {
    return perturb_model(read(file), configuration.perturbations, configuration.seed, source.id, model);
  };
  Bench bench(shape_key(depends_on, configuration.preparation, configuration.perturbations, configuration.seed),
              perturbed, configuration.preparation, parallel, cache);
  const bool viewed = configuration.report.views && dataset.models.size() <= max_models_with_views;
  ModelDescription description =
      describe_shape(bench, configuration, plan, viewed ? faces_of_views(dataset.models.size()) : 0);
  description.sha256 = hash;
  return description;
}

}  // namespace

ModelDescription describe_model(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                std::span<const PlannedField> plan, bool parallel, Cache& cache) {
  return describe_source(dataset, model, configuration, plan, parallel, cache,
                         [](const ShapeSource& file) { return read_shape(file); });
}

bool is_described(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                  std::span<const PlannedField> plan, Cache& cache) {
  try {
    (void)describe_source(dataset, model, configuration, plan, false, cache,
                          [](const ShapeSource&) -> Shape { throw NotStored(); });
    return true;
  } catch (const NotStored&) {
    return false;
  }
}

ScalarField kept_field(const FieldDescription& field) {
  return {.values = field.values.cast<double>(), .weights = field.weights.cast<double>()};
}

Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options) {
  return histogram(kept_field(field), range, options);
}

}  // namespace shapegauge
