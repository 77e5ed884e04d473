#include "shapegauge/experiments/configuration/segmentation_experiment.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/schema.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> algorithms{"best", "paper"};
constexpr std::array<std::string_view, 2> fields{"offset", "cone"};
constexpr std::array<std::string_view, 2> weights{"faces", "area"};

SegmentationMethod method_of(const Json& settings) {
  const ParameterValues values = read_parameters(segmentation_method_parameters(), settings);
  SegmentationMethod method;
  method.name = settings.at("name");
  method.paper = values.word("method") == "paper";
  method.parts = static_cast<int>(values.integer("parts"));
  for (const char* key : {"field", "offset"}) {
    if (!method.paper && settings.contains(key)) {
      throw ConfigurationError{key, "goes with the method \"paper\" only; remove it"};
    }
  }
  method.offset_field = values.word("field") == "offset";
  if (!method.offset_field && settings.contains("offset")) {
    throw ConfigurationError{"offset", "does not go with the field \"cone\"; remove it"};
  }
  method.offset = values.number("offset");
  return method;
}

std::vector<SegmentationMethod> methods_of(const Json& settings) {
  std::vector<SegmentationMethod> methods;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    SegmentationMethod method = at(std::to_string(i), [&] { return method_of(settings[i]); });
    const auto earlier = std::ranges::find(methods, method.name, &SegmentationMethod::name);
    if (earlier != methods.end()) {
      throw ConfigurationError{fmt::format("{}.name", i), fmt::format("\"{}\" is the name of segmentation.{} already",
                                                                      method.name, earlier - methods.begin())};
    }
    methods.push_back(std::move(method));
  }
  return methods;
}

SegmentationExperiment checked_experiment(const Json& document, const fs::path& folder) {
  SegmentationExperiment experiment;
  experiment.name = document.at("name");
  experiment.description = document.value("description", "");
  const Json& dataset = document.at("dataset");
  if (dataset.contains("generate")) {
    experiment.generator = at("dataset", [&] { return read_generator(dataset); });
  } else {
    experiment.root = at("dataset", [&] { return path_value(dataset, "root", folder); });
  }
  const ParameterValues values = read_parameters(segmentation_experiment_parameters(), document);
  experiment.by_area = values.word("by") == "area";
  experiment.cuts = values.boolean("cuts");
  experiment.pictures = values.boolean("pictures");
  experiment.on_error = read_on_error(document);
  experiment.methods = at("segmentation", [&] { return methods_of(document.at("segmentation")); });
  return experiment;
}

}  // namespace

std::span<const Parameter> segmentation_method_parameters() {
  const SegmentationMethod usual;
  static const std::array parameters{
      Parameter{.name = "method",
                .kind = ParameterKind::choice,
                .default_value = algorithms[0],
                .choices = algorithms,
                .description = "best: as people cut; paper: clusters of patches by their SDF, as the paper has it."},
      Parameter{.name = "parts",
                .kind = ParameterKind::integer,
                .default_value = std::int64_t{usual.parts},
                .bounds = {.low = 0, .high = 1'000'000},
                .description = "Parts wanted (paper: clusters); 0: as many as there are (paper: 5 clusters)."},
      Parameter{.name = "field",
                .kind = ParameterKind::choice,
                .default_value = fields[0],
                .choices = fields,
                .description = "paper: the SDF of the offset surface, or the conventional one."},
      Parameter{.name = "offset",
                .default_value = usual.offset,
                .bounds = OffsetSdfOptions::offset_bounds,
                .description = "paper: of the offset surface, a fraction of the bounding box's diagonal."}};
  return parameters;
}

std::span<const Parameter> segmentation_experiment_parameters() {
  static const std::array parameters{
      Parameter{.name = "by",
                .kind = ParameterKind::choice,
                .default_value = weights[0],
                .choices = weights,
                .description = "What a triangle counts: all alike, as the benchmark has it, or by area."},
      Parameter{.name = "cuts",
                .kind = ParameterKind::boolean,
                .default_value = false,
                .description = "The cut discrepancy too, which takes the longest."},
      Parameter{.name = "pictures",
                .kind = ParameterKind::boolean,
                .default_value = true,
                .description = "Pictures of the parts in the report."},
      on_error_parameter()};
  return parameters;
}

bool is_segmentation(const Json& document) { return document.is_object() && document.contains("segmentation"); }

Json to_json(const SegmentationMethod& method) {
  Json json{{"name", method.name}, {"method", algorithms.at(method.paper ? 1 : 0)}, {"parts", method.parts}};
  if (!method.paper) return json;
  json["field"] = fields.at(method.offset_field ? 0 : 1);
  if (method.offset_field) json["offset"] = method.offset;
  return json;
}

Json to_json(const SegmentationExperiment& experiment) {
  Json json{{"name", experiment.name},
            {"by", weights.at(experiment.by_area ? 1 : 0)},
            {"cuts", experiment.cuts},
            {"pictures", experiment.pictures},
            {"on_error", experiment.on_error == OnError::stop ? "stop" : "skip"}};
  if (!experiment.description.empty()) json["description"] = experiment.description;
  if (experiment.generator) {
    json["dataset"]["generate"] = to_json(*experiment.generator);
  } else {
    json["dataset"] = {{"layout", "psb_segmentation"},
                       {"root", fs::absolute(experiment.root).lexically_normal().string()}};
  }
  for (const SegmentationMethod& method : experiment.methods) json["segmentation"].push_back(to_json(method));
  return json;
}

SegmentationExperiment segmentation_from_json(const Json& document, const std::string& source, const fs::path& folder) {
  check_against_schema(document, source);
  try {
    return checked_experiment(document, folder);
  } catch (const ConfigurationError& error) {
    throw InputError(fmt::format("{}: {}: {}", source, error.path, printable(error.message, 500)));
  }
}

}  // namespace shapegauge
