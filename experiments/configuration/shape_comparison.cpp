// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/shape_comparison.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/configuration/short_forms.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

Json to_json(const ComparedShape& shape) {
  Json json{{"name", shape.name}, {"perturbations", to_json(shape.perturbations)}};
  if (shape.generated) {
    json["generate"] = to_json(*shape.generated);
  } else {
    json["file"] = std::filesystem::absolute(shape.file).lexically_normal().string();
  }
  return json;
}

GeneratedModel generated_of(const Json& settings) {
  const ParameterValues values = read_parameters(generated_model_parameters(), settings);
  return {.model_class = std::string(values.word("class")),
          .model = static_cast<int>(values.integer("model")),
          .faces = static_cast<int>(values.integer("faces")),
          .seed = static_cast<std::uint64_t>(values.integer("seed"))};
}

ComparedShape shape_of(const Json& settings, const fs::path& folder) {
  ComparedShape shape;
  shape.name = settings.at("name");
  if (settings.contains("generate")) {
    if (settings.contains("file"))
      throw ConfigurationError{"file", "cannot be combined with \"generate\"; remove one of the two"};
    shape.generated = at_key("generate", [&] { return generated_of(settings.at("generate")); });
  } else {
    shape.file = path_value(settings, "file", folder);
  }
  if (settings.contains("perturbations")) shape.perturbations = make_perturbations(settings.at("perturbations"));
  return shape;
}

std::vector<ComparedShape> shapes_of(const Json& settings, const fs::path& folder) {
  std::vector<ComparedShape> shapes;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    ComparedShape shape = at_key(std::to_string(i), [&] { return shape_of(settings[i], folder); });
    const auto earlier = std::ranges::find(shapes, shape.name, &ComparedShape::name);
    if (earlier != shapes.end()) {
      throw ConfigurationError{fmt::format("{}.name", i), fmt::format("the name \"{}\" is already that of shapes.{}",
                                                                      shape.name, earlier - shapes.begin())};
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::size_t reference_of(const std::string& name, const std::vector<ComparedShape>& shapes) {
  std::vector<std::string> names;
  names.reserve(shapes.size());
  for (const ComparedShape& shape : shapes) names.push_back(shape.name);
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    throw ConfigurationError{"reference", fmt::format("there is no shape \"{}\"{}", name, suggestion(name, names))};
  }
  return static_cast<std::size_t>(found - names.begin());
}

ShapeComparison checked_comparison(const Json& document, const fs::path& folder) {
  ShapeComparison comparison;
  comparison.name = document.at("name");
  comparison.description = document.value("description", "");
  comparison.shapes = at_key("shapes", [&] { return shapes_of(document.at("shapes"), folder); });
  if (document.contains("reference")) {
    comparison.reference = reference_of(document.at("reference"), comparison.shapes);
  } else if (document.contains("registered")) {
    throw ConfigurationError{"registered", "needs a \"reference\" that the shapes are compared with"};
  }
  comparison.registered = document.value("registered", comparison.reference.has_value());
  comparison.seed = read_seed(document);
  if (document.contains("preparation")) comparison.preparation = read_preparation(document["preparation"]);
  comparison.on_error = read_on_error(document);
  comparison.distance = document.value("distance", comparison.distance);
  comparison.signatures = at_key("signatures", [&] { return read_signatures(document.at("signatures")); });
  return comparison;
}

}  // namespace

Json to_json(const GeneratedModel& generated) {
  return {{"class", generated.model_class},
          {"model", generated.model},
          {"faces", generated.faces},
          {"seed", generated.seed}};
}

Json to_json(const ShapeComparison& comparison) {
  Json json{{"name", comparison.name},
            {"seed", comparison.seed},
            {"preparation", to_json(comparison.preparation)},
            {"on_error", word_of(comparison.on_error)},
            {"signatures", to_json(comparison.signatures)},
            {"distance", comparison.distance}};
  for (const ComparedShape& shape : comparison.shapes) json["shapes"].push_back(to_json(shape));
  if (!comparison.description.empty()) json["description"] = comparison.description;
  if (comparison.reference) {
    json["reference"] = comparison.shapes[*comparison.reference].name;
    json["registered"] = comparison.registered;
  }
  return json;
}

ShapeComparison comparison_from_json(const Json& given, const std::string& source, const fs::path& folder) {
  Json document = given;
  expand_short_forms(document);
  check_against_schema(document, "comparison_experiment", source);
  return with_source(source, [&] { return checked_comparison(document, folder); });
}

}  // namespace shapegauge
