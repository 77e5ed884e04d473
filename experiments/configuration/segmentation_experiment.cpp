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
constexpr std::array<std::string_view, 3> settings_of_best{"patches", "least_probability", "border_width"};
constexpr std::array<std::string_view, 2> settings_of_paper{"field", "offset"};

std::vector<SegmentationMethod> methods_of(const Json& settings) {
  std::vector<SegmentationMethod> methods;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    SegmentationMethod method = at_key(std::to_string(i), [&] { return segmentation_method(settings[i]); });
    const auto earlier = std::ranges::find(methods, method.name, &SegmentationMethod::name);
    if (earlier != methods.end()) {
      throw ConfigurationError{
          fmt::format("{}.name", i),
          fmt::format("the name \"{}\" is already that of segmentation.{}", method.name, earlier - methods.begin())};
    }
    methods.push_back(std::move(method));
  }
  return methods;
}

DatasetLocation location_of(const Json& dataset, const fs::path& folder) {
  if (dataset.at("layout") != segmentation_layout) return read_location(dataset, folder);
  for (const char* key : {"classification", "split"}) {
    if (dataset.contains(key))
      throw ConfigurationError{key, fmt::format("{} has none; remove it", segmentation_layout)};
  }
  return {.layout = std::string(segmentation_layout),
          .root = path_value(dataset, "root", folder),
          .classification = {},
          .split = {}};
}

SegmentationExperiment checked_experiment(const Json& document, const fs::path& folder) {
  SegmentationExperiment experiment;
  experiment.name = document.at("name");
  experiment.description = document.value("description", "");
  const Json& dataset = document.at("dataset");
  if (dataset.contains("generate")) {
    experiment.generator = at_key("dataset", [&] { return read_generator(dataset); });
  } else {
    experiment.location = at_key("dataset", [&] { return location_of(dataset, folder); });
  }
  const ParameterValues values = read_parameters(segmentation_experiment_parameters(), document);
  experiment.by_area = values.word("by") == "area";
  experiment.cuts = values.boolean("cuts");
  experiment.pictures = values.boolean("pictures");
  experiment.on_error = read_on_error(document);
  experiment.seed = read_seed(document);
  experiment.methods = at_key("segmentation", [&] { return methods_of(document.at("segmentation")); });
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
                .description =
                    "best: parts as people choose them; paper: clusters of patches by their SDF, as in the paper."},
      Parameter{.name = "parts",
                .kind = ParameterKind::integer,
                .default_value = std::int64_t{usual.parts},
                .bounds = {.low = 0, .high = 1'000'000},
                .description = "Number of parts (paper: of clusters); 0 for automatic (paper: 5 clusters)."},
      Parameter{.name = "patches",
                .kind = ParameterKind::integer,
                .default_value = std::int64_t{usual.patches},
                .bounds = {.low = 1, .high = 100'000},
                .description = "best: number of initial patches."},
      Parameter{.name = "least_probability",
                .default_value = usual.least_probability,
                .bounds = {.low = 0, .high = 1},
                .description = "best: least probability at which two regions are merged."},
      Parameter{.name = "border_width",
                .default_value = usual.border_width,
                .bounds = {.low = 0, .high = 1},
                .description = "best: largest distance that smoothing may move borders.",
                .unit = "square roots of the area"},
      Parameter{.name = "field",
                .kind = ParameterKind::choice,
                .default_value = fields[0],
                .choices = fields,
                .description = "paper: SDF of the offset surface, or conventional SDF."},
      Parameter{.name = "offset",
                .default_value = usual.offset,
                .bounds = OffsetSdfOptions::offset_bounds,
                .description = "paper: offset distance.",
                .unit = bounding_box_diagonals}};
  return parameters;
}

std::span<const Parameter> segmentation_experiment_parameters() {
  static const std::vector<Parameter> parameters = [] {
    std::vector<Parameter> all{Parameter{.name = "by",
                                         .kind = ParameterKind::choice,
                                         .default_value = weights[0],
                                         .choices = weights,
                                         .description = "Weight per triangle: equal, as in the benchmark, or by area."},
                               Parameter{.name = "cuts",
                                         .kind = ParameterKind::boolean,
                                         .default_value = false,
                                         .description = "Also compute the cut discrepancy, which takes the longest."},
                               Parameter{.name = "pictures",
                                         .kind = ParameterKind::boolean,
                                         .default_value = true,
                                         .description = "Pictures of the parts in the report."}};
    all.insert(all.end(), experiment_parameters().begin(), experiment_parameters().end());
    return all;
  }();
  return parameters;
}

SegmentationMethod segmentation_method(const Json& settings) {
  const ParameterValues values = read_parameters(segmentation_method_parameters(), settings);
  SegmentationMethod method;
  method.name = settings.at("name");
  method.paper = values.word("method") == "paper";
  method.parts = static_cast<int>(values.integer("parts"));
  using Names = std::span<const std::string_view>;
  const Names foreign = method.paper ? Names(settings_of_best) : Names(settings_of_paper);
  for (const std::string_view key : foreign) {
    if (!settings.contains(key)) continue;
    throw ConfigurationError{std::string(key),
                             fmt::format("requires the method \"{}\"; remove it", algorithms.at(method.paper ? 0 : 1))};
  }
  method.patches = static_cast<int>(values.integer("patches"));
  method.least_probability = values.number("least_probability");
  method.border_width = values.number("border_width");
  method.offset_field = values.word("field") == "offset";
  if (!method.offset_field && settings.contains("offset")) {
    throw ConfigurationError{"offset", "cannot be combined with the field \"cone\"; remove it"};
  }
  method.offset = values.number("offset");
  if (settings.contains("perturbations")) method.perturbations = make_perturbations(settings["perturbations"]);
  return method;
}

bool is_segmentation(const Json& document) { return document.is_object() && document.contains("segmentation"); }

Json to_json(const SegmentationMethod& method) {
  Json json{{"name", method.name}, {"method", algorithms.at(method.paper ? 1 : 0)}, {"parts", method.parts}};
  if (!method.perturbations.empty()) json["perturbations"] = to_json(method.perturbations);
  if (!method.paper) {
    json["patches"] = method.patches;
    json["least_probability"] = method.least_probability;
    json["border_width"] = method.border_width;
    return json;
  }
  json["field"] = fields.at(method.offset_field ? 0 : 1);
  if (method.offset_field) json["offset"] = method.offset;
  return json;
}

Json to_json(const SegmentationExperiment& experiment) {
  Json json{{"name", experiment.name}, {"by", weights.at(experiment.by_area ? 1 : 0)},
            {"cuts", experiment.cuts}, {"pictures", experiment.pictures},
            {"seed", experiment.seed}, {"on_error", experiment.on_error == OnError::stop ? "stop" : "skip"}};
  if (!experiment.description.empty()) json["description"] = experiment.description;
  if (experiment.generator) {
    json["dataset"]["generate"] = to_json(*experiment.generator);
  } else {
    json["dataset"] = to_json(experiment.location);
  }
  for (const SegmentationMethod& method : experiment.methods) json["segmentation"].push_back(to_json(method));
  return json;
}

SegmentationExperiment segmentation_from_json(const Json& document, const std::string& source, const fs::path& folder) {
  check_against_schema(document, source);
  if (!is_segmentation(document)) {
    throw InputError(fmt::format("{}: has no \"segmentation\": it is not an experiment of segmentation", source));
  }
  try {
    return checked_experiment(document, folder);
  } catch (const ConfigurationError& error) {
    throw InputError(fmt::format("{}: {}: {}", source, error.path, printable(error.message, 500)));
  }
}

}  // namespace shapegauge
