#include "shapegauge/experiments/configuration/read_configuration.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include "shapegauge/core/error.h"
#include "shapegauge/core/printable.h"
#include "shapegauge/experiments/configuration/apply_override.h"
#include "shapegauge/experiments/configuration/misplaced_value.h"
#include "shapegauge/experiments/configuration/parse_json.h"
#include "shapegauge/experiments/configuration/path_value.h"
#include "shapegauge/experiments/configuration/preparation_settings.h"
#include "shapegauge/experiments/configuration/read_report.h"
#include "shapegauge/experiments/configuration/read_signatures.h"
#include "shapegauge/experiments/configuration/schema_check.h"
#include "shapegauge/experiments/datasets/dataset_layouts.h"
#include "shapegauge/experiments/perturbations/perturbation_registry.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

DatasetLocation location_of(const Json& dataset, const fs::path& folder) {
  DatasetLocation location;
  location.layout = dataset.at("layout");
  location.root = path_value(dataset, "root", folder);
  if (location.layout == "folders") {
    if (dataset.contains("classification")) {
      throw MisplacedValue{"classification", "the layout \"folders\" has its classes in the folders' names"};
    }
    location.split = dataset.value("split", location.split);
    return location;
  }
  if (dataset.contains("split")) throw MisplacedValue{"split", "only the layout \"folders\" has a split"};
  location.classification = dataset.contains("classification")
                                ? path_value(dataset, "classification", location.root)
                                : location.root / dataset_layout(location.layout).usual_classification;
  return location;
}

GeneratorOptions generator_of(const Json& dataset) {
  for (const auto& [key, value] : dataset.items()) {
    if (key != "generate") {
      throw MisplacedValue{key, "does not go with \"generate\"; remove one of the two"};
    }
  }
  const Json& settings = dataset.at("generate");
  GeneratorOptions options;
  options.classes = settings.value("classes", options.classes);
  options.models_per_class = settings.value("models_per_class", options.models_per_class);
  options.faces = settings.value("faces", options.faces);
  options.seed = settings.value("seed", options.seed);
  const std::size_t known = generated_class_names().size();
  if (static_cast<std::size_t>(options.classes) > known) {
    throw MisplacedValue{"generate.classes", fmt::format("there are {} classes, not {}", known, options.classes)};
  }
  return options;
}

std::vector<Protocol> protocols_of(const Json& setting) {
  std::vector<Protocol> protocols;
  const auto add = [&](const Json& name) { protocols.push_back(protocol_of(name.get<std::string>()).value()); };
  if (setting.is_array()) {
    std::ranges::for_each(setting, add);
  } else {
    add(setting);
  }
  return protocols;
}

void read_evaluation(const Json& setting, Configuration& configuration) {
  configuration.minimum_class_size = setting.value("minimum_class_size", configuration.minimum_class_size);
  configuration.ties = ties_of(setting.value("ties", name_of(configuration.ties))).value();
  if (!setting.contains("measures")) return;
  try {
    configuration.measures = measures_of(setting["measures"].get<std::vector<std::string>>());
  } catch (const std::invalid_argument& error) {
    throw MisplacedValue{"measures", error.what()};
  }
}

Configuration checked_configuration(const Json& document, const fs::path& folder) {
  Configuration configuration;
  configuration.name = document.at("name");
  configuration.description = document.value("description", "");
  const Json& dataset = document.at("dataset");
  if (dataset.contains("generate")) {
    configuration.generator = at("dataset", [&] { return generator_of(dataset); });
  } else {
    configuration.location = at("dataset", [&] { return location_of(dataset, folder); });
  }
  configuration.seed = document.value("seed", configuration.seed);
  if (document.contains("preparation")) configuration.preparation = read_preparation(document["preparation"]);
  if (document.contains("perturbations")) configuration.perturbations = make_perturbations(document["perturbations"]);
  if (document.contains("protocol")) configuration.protocols = protocols_of(document["protocol"]);
  configuration.measures = default_measures(configuration.protocols);
  if (document.contains("evaluation"))
    at("evaluation", [&] { read_evaluation(document["evaluation"], configuration); });
  configuration.on_error = document.value("on_error", "stop") == "skip" ? OnError::skip : OnError::stop;
  configuration.distance = document.value("distance", configuration.distance);
  configuration.signatures = at("signatures", [&] { return read_signatures(document.at("signatures")); });
  configuration.report =
      at("report", [&] { return read_report(document.value("report", Json(true)), configuration.signatures); });
  return configuration;
}

}  // namespace

Configuration configuration_from_json(const Json& document, const std::string& source, const fs::path& folder) {
  check_against_schema(document, source);
  if (is_comparison(document)) {
    throw InputError(fmt::format("{}: compares \"shapes\": it is not a retrieval experiment", source));
  }
  try {
    return checked_configuration(document, folder);
  } catch (const MisplacedValue& error) {
    throw InputError(fmt::format("{}: {}: {}", source, error.path, printable(error.message, 500)));
  }
}

Json read_configuration_document(const fs::path& path, std::span<const std::string> overrides) {
  Json document = read_json(path);
  for (const std::string& assignment : overrides) apply_override(document, assignment);
  return document;
}

bool is_comparison(const Json& document) { return document.is_object() && document.contains("shapes"); }

Configuration read_configuration(const fs::path& path, std::span<const std::string> overrides) {
  return configuration_from_json(read_configuration_document(path, overrides), path.string(), path.parent_path());
}

}  // namespace shapegauge
