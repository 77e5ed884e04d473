// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/segmentation_experiment.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/schema.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// Returns true if the parameter of segmentation_table has an effect with the options.
bool applies(std::string_view parameter, const SegmentationOptions& options) {
  const std::optional<SegmentationAlgorithm> only = algorithm_with(parameter);
  if (only && *only != options.method) return false;
  return parameter != "offset" || options.field == SegmentedSdf::offset;
}

std::vector<SegmentationMethod> methods_of(const Json& settings) {
  unique_names(settings, "segmentation");
  std::vector<SegmentationMethod> methods;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    methods.push_back(at_key(std::to_string(i), [&] { return segmentation_method(settings[i]); }));
  }
  return methods;
}

DatasetLocation location_of(const Json& dataset, const fs::path& folder) {
  if (dataset.at("layout") != segmentation_layout) return read_location(dataset, folder);
  for (const char* key : {"classification", "split"}) {
    if (dataset.contains(key))
      throw ConfigurationError{key, fmt::format("the layout {} has none; remove it", segmentation_layout)};
  }
  return {.layout = std::string(segmentation_layout),
          .root = path_value(dataset, "root", folder),
          .classification = {},
          .split = {}};
}

SegmentationExperiment checked_experiment(const Json& document, const fs::path& folder) {
  SegmentationExperiment experiment;
  read_shared_settings(document, experiment);
  const Json& dataset = document.at("dataset");
  if (dataset.contains("generate")) {
    experiment.generator = at_key("dataset", [&] { return read_generator(dataset); });
  } else {
    experiment.location = at_key("dataset", [&] { return location_of(dataset, folder); });
  }
  const ParameterValues values = read_parameters(segmentation_experiment_parameters(), document);
  experiment.by = member_value<TriangleWeights>(values.value("by"));
  experiment.cuts = values.boolean("cuts");
  experiment.pictures = values.boolean("pictures");
  experiment.up = member_value<UpAxis>(values.value("up"));
  experiment.methods = at_key("segmentation", [&] { return methods_of(document.at("segmentation")); });
  return experiment;
}

}  // namespace

std::span<const Parameter> segmentation_method_parameters() {
  static constexpr auto parameters = parameters_of(segmentation_table);
  return parameters;
}

std::span<const Parameter> segmentation_experiment_parameters() {
  static const std::vector<Parameter> parameters = [] {
    std::vector<Parameter> all{Parameter{.name = "by",
                                         .kind = ParameterKind::choice,
                                         .default_value = word_of(TriangleWeights::faces),
                                         .choices = words_of<TriangleWeights>,
                                         .description = "Weight of a triangle in the error measures. faces: 1, as in "
                                                        "the Princeton Segmentation Benchmark; area: its area."},
                               Parameter{.name = "cuts",
                                         .kind = ParameterKind::boolean,
                                         .default_value = false,
                                         .description = "Also compute the cut discrepancy, the slowest error measure."},
                               Parameter{.name = "pictures",
                                         .kind = ParameterKind::boolean,
                                         .default_value = true,
                                         .description = "Add pictures of the parts to the report."},
                               up_parameter()};
    all.insert(all.end(), experiment_parameters().begin(), experiment_parameters().end());
    return all;
  }();
  return parameters;
}

SegmentationMethod segmentation_method(const Json& settings) {
  SegmentationMethod method{
      .name = settings.at("name"), .options = read_options(segmentation_table, settings), .perturbations = {}};
  for (const Parameter& parameter : segmentation_method_parameters()) {
    if (!settings.contains(parameter.name) || applies(parameter.name, method.options)) continue;
    const std::optional<SegmentationAlgorithm> only = algorithm_with(parameter.name);
    const std::string reason =
        only && *only != method.options.method
            ? fmt::format("requires the method \"{}\"", word_of(*only))
            : fmt::format("cannot be combined with the field \"{}\"", word_of(SegmentedSdf::cone));
    throw ConfigurationError{std::string(parameter.name), reason + "; remove it"};
  }
  if (settings.contains("perturbations")) method.perturbations = make_perturbations(settings["perturbations"]);
  return method;
}

Json to_json(const SegmentationMethod& method) {
  Json json = options_json(segmentation_table, method.options);
  for (const Parameter& parameter : segmentation_method_parameters()) {
    if (!applies(parameter.name, method.options)) json.erase(std::string(parameter.name));
  }
  json["name"] = method.name;
  if (!method.perturbations.empty()) json["perturbations"] = to_json(method.perturbations);
  return json;
}

Json to_json(const SegmentationExperiment& experiment) {
  Json json = shared_settings_json(experiment);
  json["by"] = word_of(experiment.by);
  json["cuts"] = experiment.cuts;
  json["pictures"] = experiment.pictures;
  json["up"] = word_of(experiment.up);
  if (experiment.generator) {
    json["dataset"]["generate"] = to_json(*experiment.generator);
  } else {
    json["dataset"] = to_json(experiment.location);
  }
  for (const SegmentationMethod& method : experiment.methods) json["segmentation"].push_back(to_json(method));
  return json;
}

SegmentationExperiment segmentation_from_json(const Json& document, const std::string& source, const fs::path& folder) {
  check_against_schema(document, "segmentation_experiment", source);
  return with_source(source, [&] { return checked_experiment(document, folder); });
}

}  // namespace shapegauge
