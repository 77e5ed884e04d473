// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/describe_model.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/signatures/cache_keys.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

std::size_t index_of(std::span<const Field> fields, const Field& field) {
  return static_cast<std::size_t>(std::ranges::find(fields, field.settings, &Field::settings) - fields.begin());
}

std::vector<Field> distinct_fields(const std::vector<SignatureConfiguration>& signatures) {
  std::vector<Field> fields;
  const auto add = [&](const Field& field) {
    if (index_of(fields, field) == fields.size()) fields.push_back(field);
  };
  for (const SignatureConfiguration& signature : signatures) {
    if (signature.field) add(*signature.field);
    if (signature.descriptor) std::ranges::for_each(signature.descriptor->fields, add);
  }
  return fields;
}

std::optional<std::size_t> first_histogram_of(const Field& field,
                                              const std::vector<SignatureConfiguration>& signatures) {
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    if (signatures[i].field && signatures[i].field->settings == field.settings) return i;
  }
  return std::nullopt;
}

std::string error_of_fields(const ModelDescription& model, std::span<const Field> fields,
                            const DescriptorChoice& descriptor) {
  for (const Field& field : descriptor.fields) {
    const std::string& error = model.fields[index_of(fields, field)].error;
    if (!error.empty()) return error;
  }
  return {};
}

std::vector<std::string> signature_errors(const ModelDescription& model,
                                          const std::vector<SignatureConfiguration>& signatures,
                                          std::span<const Field> fields) {
  std::vector<std::string> errors(signatures.size());
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    if (signatures[i].field) errors[i] = model.fields[index_of(fields, *signatures[i].field)].error;
    if (!signatures[i].descriptor) continue;
    errors[i] = error_of_fields(model, fields, *signatures[i].descriptor);
    if (errors[i].empty()) errors[i] = model.features[i].error;
  }
  for (const std::size_t i : computation_order(signatures)) {
    for (const std::size_t part : signatures[i].parts) {
      if (errors[i].empty()) errors[i] = errors[part];
    }
  }
  return errors;
}

bool is_pictured(const Field& field, const Configuration& configuration) {
  const ReportConfiguration& report = configuration.report;
  if (!report.enabled || !report.pictures) return false;
  return field.settings == pictured_field(configuration.signatures[report.pictured_signature])->settings;
}

std::vector<std::size_t> viewed_fields(std::span<const Field> fields, const Configuration& configuration) {
  std::vector<std::size_t> viewed;
  const ReportConfiguration& report = configuration.report;
  if (!report.enabled || !report.pictures || !report.views) return viewed;
  for (const bool pictured : {true, false}) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (is_pictured(fields[i], configuration) != pictured) continue;
      if (!pictured && !first_histogram_of(fields[i], configuration.signatures)) continue;
      if (viewed.size() < max_viewed_fields) viewed.push_back(i);
    }
  }
  return viewed;
}

namespace {

/// Returns true if a signature depends on the values of the field on all shapes: a histogram over their range, or a
/// descriptor that learns.
bool is_for_all_shapes(const Field& field, const std::vector<SignatureConfiguration>& signatures) {
  return std::ranges::any_of(signatures, [&](const SignatureConfiguration& signature) {
    if (signature.field && signature.histogram.range == HistogramRange::dataset) {
      return signature.field->settings == field.settings;
    }
    if (!signature.descriptor || !needs_learning(*signature.descriptor)) return false;
    const std::vector<Field>& fields = signature.descriptor->fields;
    return index_of(fields, field) < fields.size();
  });
}

}  // namespace

FieldDescription describe_field(const StoredField& values, const Eigen::VectorXd& weights, const Field& field,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::vector<FeatureDescription>& features) {
  FieldDescription description{.range = values.range,
                               .values = {},
                               .weights = {},
                               .outcomes = values.outcomes,
                               .offset = values.offset,
                               .seconds = values.seconds};
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    if (!signatures[i].field || signatures[i].field->settings != field.settings) continue;
    const HistogramConfiguration& settings = signatures[i].histogram;
    if (settings.range == HistogramRange::dataset) continue;
    const Interval& range = settings.range == HistogramRange::fixed ? settings.fixed : values.range;
    features[i].features = histogram({.values = values.values, .weights = weights}, range, settings.options);
  }
  if (is_for_all_shapes(field, signatures)) {
    description.values = values.values.cast<float>();
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

FeatureDescription describe_descriptor(CachedShape& bench, const DescriptorChoice& choice,
                                       const ModelDescription& description, std::span<const Field> fields,
                                       OnError on_error) {
  FeatureDescription features;
  if (needs_learning(choice)) return features;  // completed after all shapes
  features.error = error_of_fields(description, fields, choice);
  if (!features.error.empty()) return features;
  const std::string error = error_of(on_error, [&] { features = bench.features(choice); });
  if (!error.empty()) features.error = error;
  return features;
}

/// Adds the picture and the view.
void draw(CachedShape& bench, const Configuration& configuration, std::span<const Field> fields,
          const ShapeDrawing& drawing, ModelDescription& description) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!is_pictured(fields[i], configuration) || !description.fields[i].error.empty()) continue;
    description.picture = bench.picture(fields[i], configuration.report.picture_options, drawing.up);
  }
  std::vector<Field> viewed;
  std::vector<bool> has_field;
  for (const std::size_t i : viewed_fields(fields, configuration)) {
    viewed.push_back(fields[i]);
    has_field.push_back(description.fields[i].error.empty());
  }
  if (drawing.faces > 0 && !viewed.empty()) description.view = bench.view(viewed, has_field, drawing);
}

}  // namespace

ModelDescription describe_shape(CachedShape& bench, const Configuration& configuration, std::span<const Field> fields,
                                const ShapeDrawing& drawing) {
  const std::vector<SignatureConfiguration>& signatures = configuration.signatures;
  ModelDescription description;
  static_cast<ShapeFacts&>(description) = bench.facts();
  description.shape_key = bench.key();
  description.features.resize(signatures.size());
  for (const Field& field : fields) {
    FieldDescription described;
    const std::string error = error_of(configuration.on_error, [&] {
      described = describe_field(bench.field(field), bench.weights(field.settings.samples), field, signatures,
                                 description.features);
    });
    if (!error.empty()) described.error = error;
    description.fields.push_back(std::move(described));
  }
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    if (!signatures[i].descriptor) continue;
    description.features[i] =
        describe_descriptor(bench, *signatures[i].descriptor, description, fields, configuration.on_error);
  }
  draw(bench, configuration, fields, drawing, description);
  return description;
}

namespace {

/// A result is not in the cache.
struct NotStored {};

/// Model with the bytes of its file.
struct OpenedModel {
  ShapeSource file;
  std::string hash;
  std::string key;  ///< shape_key()
};

OpenedModel open_model(const Dataset& dataset, std::size_t model, const Configuration& configuration) {
  const Model& source = dataset.models[model];
  OpenedModel opened{.file = read_shape_source(source.file), .hash = {}, .key = {}};
  opened.hash = sha256_of_shape(opened.file);
  opened.key = shape_key({.sha256 = opened.hash, .file = source.file, .id = source.id, .index = model},
                         configuration.preparation, configuration.perturbations, configuration.seed);
  return opened;
}

/// Describes a model; `read` returns the shape of its file.
ModelDescription describe_opened(const Dataset& dataset, std::size_t model, const OpenedModel& opened,
                                 const Configuration& configuration, std::span<const Field> fields, bool parallel,
                                 Cache& cache, const std::function<Shape(const ShapeSource&)>& read) {
  const auto perturbed = [&] {
    return perturb_model(read(opened.file), configuration.perturbations, configuration.seed, dataset.models[model].id,
                         model);
  };
  CachedShape bench(opened.key, perturbed, configuration.preparation, parallel, cache);
  const bool viewed = configuration.report.views && dataset.models.size() <= max_models_with_views;
  const ShapeDrawing drawing{.faces = viewed ? faces_of_views(dataset.models.size()) : 0,
                             .up = up_direction(configuration.report.up, dataset.models[model].file)};
  ModelDescription description = describe_shape(bench, configuration, fields, drawing);
  description.sha256 = opened.hash;
  return description;
}

/// Returns the key of note_failure().
std::string failure_key(const std::string& shape, const Configuration& configuration, std::span<const Field> fields) {
  nlohmann::json results = nlohmann::json::array();
  for (const Field& field : fields) results.push_back(field_key(shape, field));
  for (const SignatureConfiguration& signature : configuration.signatures) {
    if (signature.descriptor) results.push_back(features_key(shape, *signature.descriptor, {}, ""));
  }
  return result_key(EntryKind::shape, {{"failed", std::move(results)}, {"shape", shape}});
}

}  // namespace

ModelDescription describe_model(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                std::span<const Field> fields, bool parallel, Cache& cache) {
  return describe_opened(dataset, model, open_model(dataset, model, configuration), configuration, fields, parallel,
                         cache, [](const ShapeSource& file) { return read_shape(file); });
}

bool is_described(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                  std::span<const Field> fields, Cache& cache) {
  std::string key;
  try {
    const OpenedModel opened = open_model(dataset, model, configuration);
    key = failure_key(opened.key, configuration, fields);
    (void)describe_opened(dataset, model, opened, configuration, fields, false, cache,
                          [](const ShapeSource&) -> Shape { throw NotStored(); });
    return true;
  } catch (const NotStored&) {
    return cache.find<bool>(EntryKind::shape, key).has_value();
  } catch (const InputError&) {
    return true;  // the file cannot be read
  }
}

ModelDescription without_values(ModelDescription model) {
  for (FieldDescription& field : model.fields) field.values = field.weights = Eigen::VectorXf();
  for (FeatureDescription& features : model.features) features.features = Eigen::VectorXf();
  return model;
}

void note_failure(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                  std::span<const Field> fields, Cache& cache) {
  std::string key;
  try {
    key = failure_key(open_model(dataset, model, configuration).key, configuration, fields);
  } catch (const InputError&) {
    return;  // the file cannot be read
  }
  cache.put(EntryKind::shape, key, true);
}

ScalarField to_scalar_field(const FieldDescription& field) {
  return {.values = field.values.cast<double>(), .weights = field.weights.cast<double>()};
}

}  // namespace shapegauge
