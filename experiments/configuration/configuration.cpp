// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/configuration.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/parameter_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

enum class Visit { not_yet, under_way, done };

/// Appends the signature after its parts; returns the index of a signature that depends on itself, if any.
std::optional<std::size_t> visit(const std::vector<SignatureConfiguration>& signatures, std::size_t index,
                                 std::vector<Visit>& visits, std::vector<std::size_t>& order) {
  if (visits[index] == Visit::done) return std::nullopt;
  if (visits[index] == Visit::under_way) return index;
  visits[index] = Visit::under_way;
  for (const std::size_t part : signatures[index].parts) {
    if (const auto cyclic = visit(signatures, part, visits, order)) return cyclic;
  }
  visits[index] = Visit::done;
  order.push_back(index);
  return std::nullopt;
}

/// Returns a path that is valid in any folder: a run may be repeated elsewhere.
std::string absolute_text(const std::filesystem::path& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

Json dataset_to_json(const Configuration& configuration) {
  if (configuration.generator) return {{"generate", to_json(*configuration.generator)}};
  return to_json(configuration.location.value());
}

Json report_to_json(const Configuration& configuration) {
  const ReportConfiguration& report = configuration.report;
  if (!report.enabled) return false;
  if (!report.pictures) return {{"pictures", false}};
  const Interval& range = report.picture_options.range;
  return {{"pictures",
           {{"of", configuration.signatures[report.pictured_signature].name}, {"range", {range.low, range.high}}}},
          {"views", report.views},
          {"up", word_of(report.up)}};
}

Json evaluation_json(const EvaluationOptions& evaluation) {
  Json measures = Json::array();
  for (const Measure& measure : evaluation.measures) measures.push_back(measure.name);
  Json json = options_json(evaluation_table, evaluation);
  json["measures"] = std::move(measures);
  return json;
}

}  // namespace

std::span<const Parameter> experiment_parameters() {
  static const std::array parameters{
      Parameter{.name = "seed",
                .kind = ParameterKind::integer,
                .default_value = std::int64_t{1},
                .bounds = seed_bounds,
                .description = "Random seed of the perturbations; combined with each model's id (in shape comparisons: "
                               "name)."},
      Parameter{.name = "on_error",
                .kind = ParameterKind::choice,
                .default_value = word_of(OnError::stop),
                .choices = words_of<OnError>,
                .description =
                    "Action for an unusable shape. stop: end the run; skip: omit the shape (in retrieval, only "
                    "from the signatures that cannot use it) and list it at the end."}};
  return parameters;
}

std::span<const Parameter> histogram_parameters() {
  static constexpr auto parameters = parameters_of(histogram_table);
  return parameters;
}

std::span<const Parameter> evaluation_parameters() {
  static constexpr auto parameters = parameters_of(evaluation_table);
  return parameters;
}

std::span<const Parameter> preparation_parameters() {
  static constexpr auto parameters = parameters_of(preparation_table);
  return parameters;
}

const Field* pictured_field(const SignatureConfiguration& signature) {
  if (signature.field) return &*signature.field;
  if (signature.descriptor && !signature.descriptor->fields.empty()) return &signature.descriptor->fields.front();
  return nullptr;
}

std::optional<std::size_t> find_cyclic_signature(const std::vector<SignatureConfiguration>& signatures) {
  std::vector<std::size_t> order;
  std::vector<Visit> visits(signatures.size(), Visit::not_yet);
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    if (const auto cyclic = visit(signatures, i, visits, order)) return cyclic;
  }
  return std::nullopt;
}

std::vector<std::size_t> computation_order(const std::vector<SignatureConfiguration>& signatures) {
  std::vector<std::size_t> order;
  std::vector<Visit> visits(signatures.size(), Visit::not_yet);
  for (std::size_t i = 0; i < signatures.size(); ++i) visit(signatures, i, visits, order);
  return order;
}

Json to_json(const HistogramConfiguration& histogram) {
  Json json = options_json(histogram_table, histogram.options);
  const std::string_view range = word_of(histogram.range);
  if (histogram.range == HistogramRange::fixed) {
    json["range"][std::string(range)] = {histogram.fixed.low, histogram.fixed.high};
  } else {
    json["range"] = range;
  }
  return json;
}

Json to_json(const std::vector<SignatureConfiguration>& signatures) {
  Json list = Json::array();
  for (const SignatureConfiguration& signature : signatures) {
    Json json{{"name", signature.name}};
    if (signature.field) {
      json["field"] = to_json(signature.field->settings);
      json["histogram"] = to_json(signature.histogram);
    } else if (signature.descriptor) {
      json["descriptor"] = to_json(*signature.descriptor);
    } else if (signature.derived) {
      json.update(to_json(*signature.derived));
    } else {
      for (const std::size_t part : signature.parts) json["concatenate"].push_back(signatures[part].name);
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json to_json(const GeneratorOptions& generator) { return options_json(generator_table(), generator); }

Json shared_settings_json(const ExperimentSettings& settings) {
  Json json{{"name", settings.name},
            {"seed", settings.seed},
            {"preparation", to_json(settings.preparation)},
            {"on_error", word_of(settings.on_error)}};
  if (!settings.description.empty()) json["description"] = settings.description;
  return json;
}

Json to_json(const Configuration& configuration) {
  Json json = shared_settings_json(configuration);
  json["dataset"] = dataset_to_json(configuration);
  json["perturbations"] = to_json(configuration.perturbations);
  json["evaluation"] = evaluation_json(configuration.evaluation);
  json["signatures"] = to_json(configuration.signatures);
  json["distance"] = configuration.distance;
  json["keep_distances"] = configuration.keep_distances;
  json["report"] = report_to_json(configuration);
  for (const Protocol protocol : configuration.protocols) json["protocol"].push_back(name_of(protocol));
  return json;
}

Json to_json(const DatasetLocation& location) {
  Json json{{"layout", location.layout}, {"root", absolute_text(location.root)}};
  if (!location.classification.empty()) json["classification"] = absolute_text(location.classification);
  // Segmentation data sets have their own layout.
  const DatasetLayout* const layout = dataset_layouts().find(location.layout);
  if (layout != nullptr && layout->has_splits) json["split"] = location.split;
  return json;
}

Json to_json(const PreparationOptions& preparation) { return options_json(preparation_table, preparation); }

}  // namespace shapegauge
