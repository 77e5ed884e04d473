// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/shape_comparison.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/base/error.h"
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
    shapes.push_back(at_key(std::to_string(i), [&] { return shape_of(settings[i], folder); }));
  }
  return shapes;
}

ShapeComparison checked_comparison(const Json& document, const fs::path& folder) {
  ShapeComparison comparison;
  read_shared_settings(document, comparison);
  const Json& shapes = document.at("shapes");
  const std::vector<std::string> names = at_key("shapes", [&] { return unique_names(shapes, "shapes"); });
  comparison.shapes = at_key("shapes", [&] { return shapes_of(shapes, folder); });
  if (document.contains("reference")) {
    comparison.reference = index_of_name(document.at("reference"), names, "shape", "reference");
  } else if (document.contains("registered")) {
    throw ConfigurationError{"registered", "requires \"reference\", the name of the shape to compare with"};
  }
  comparison.registered = document.value("registered", comparison.reference.has_value());
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
  Json json = shared_settings_json(comparison);
  json["signatures"] = to_json(comparison.signatures);
  json["distance"] = comparison.distance;
  for (const ComparedShape& shape : comparison.shapes) json["shapes"].push_back(to_json(shape));
  if (comparison.reference) {
    json["reference"] = comparison.shapes[*comparison.reference].name;
    json["registered"] = comparison.registered;
  }
  return json;
}

ShapeComparison comparison_from_json(const Json& json, const std::string& source, const fs::path& folder) {
  Json document = json;
  expand_short_forms(document);
  check_against_schema(document, "comparison_experiment", source);
  return with_source(source, [&] { return checked_comparison(document, folder); });
}

}  // namespace shapegauge
