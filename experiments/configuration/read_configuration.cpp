#include "shapegauge/experiments/configuration/read_configuration.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "shapegauge/core/error.h"
#include "shapegauge/core/printable.h"
#include "shapegauge/experiments/configuration/apply_override.h"
#include "shapegauge/experiments/configuration/expand_variables.h"
#include "shapegauge/experiments/configuration/nearest_word.h"
#include "shapegauge/experiments/configuration/parse_json.h"
#include "shapegauge/experiments/configuration/schema_check.h"
#include "shapegauge/experiments/datasets/dataset_layouts.h"
#include "shapegauge/experiments/fields/field_registry.h"
#include "shapegauge/experiments/perturbations/perturbation_registry.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// An error at a place within the part of the document that is being looked at.
struct MisplacedValue {
  std::string path;
  std::string message;
};

/// Runs a step on the part of the document at a key (or index, or dotted path), and completes the place where it fails.
template <typename Step>
auto at(const std::string& key, Step step) {
  try {
    return step();
  } catch (const MisplacedValue& error) {
    throw MisplacedValue{fmt::format("{}.{}", key, error.path), error.message};
  } catch (const InputError& error) {
    throw MisplacedValue{key, error.what()};
  }
}

/// The path of a key, variables expanded, relative to the folder.
fs::path path_value(const Json& object, const std::string& key, const fs::path& folder) {
  const std::string expanded = at(key, [&] { return expand_variables(object.at(key).get<std::string>()); });
  return (folder / expanded).lexically_normal();
}

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

PreparationOptions preparation_of(const Json& settings) {
  PreparationOptions preparation;
  preparation.denoise = settings.value("denoise", preparation.denoise);
  if (settings.value("scale", "area") == "tube_area") preparation.scale = ScaleEstimate::tube_area;
  return preparation;
}

HistogramConfiguration histogram_of(const Json& settings) {
  HistogramConfiguration histogram;
  histogram.options.bins = settings.value("bins", histogram.options.bins);
  histogram.options.smoothing_bins = settings.value("smoothing_bins", histogram.options.smoothing_bins);
  if (histogram.options.smoothing_bins > histogram.options.bins) {
    throw MisplacedValue{"smoothing_bins", fmt::format("the smoothing must be at most the number of bins ({}), not {}",
                                                       histogram.options.bins, histogram.options.smoothing_bins)};
  }
  const Json& range = settings.at("range");
  if (range.is_object()) {
    histogram.range = HistogramRange::fixed;
    histogram.fixed = {.low = range.at("fixed").at(0), .high = range.at("fixed").at(1)};
    if (!(histogram.fixed.low < histogram.fixed.high)) {
      throw MisplacedValue{
          "range.fixed", fmt::format("the first value must be less than the second, not {}", range.at("fixed").dump())};
    }
    if (!std::isfinite(histogram.fixed.high - histogram.fixed.low)) {
      throw MisplacedValue{"range.fixed", fmt::format("the values are too far apart: {}", range.at("fixed").dump())};
    }
  } else {
    histogram.range = range == "dataset" ? HistogramRange::dataset : HistogramRange::per_shape;
  }
  return histogram;
}

std::vector<std::string> unique_names(const Json& signatures) {
  std::vector<std::string> names;
  for (const Json& signature : signatures) {
    const std::string name = signature.at("name");
    const auto earlier = std::ranges::find(names, name);
    if (earlier != names.end()) {
      throw MisplacedValue{fmt::format("{}.name", names.size()),
                           fmt::format("\"{}\" is the name of signatures.{} already", name, earlier - names.begin())};
    }
    names.push_back(name);
  }
  return names;
}

std::vector<std::size_t> parts_of(const Json& concatenate, const std::vector<std::string>& names) {
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < concatenate.size(); ++i) {
    const std::string name = concatenate[i];
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
      throw MisplacedValue{fmt::format("concatenate.{}", i),
                           fmt::format("there is no signature \"{}\"{}", name, suggestion(name, names))};
    }
    parts.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return parts;
}

SignatureConfiguration signature_of(const Json& settings, const std::vector<std::string>& names) {
  SignatureConfiguration signature;
  signature.name = settings.at("name");
  if (settings.contains("concatenate")) {
    for (const char* key : {"field", "histogram"}) {
      if (settings.contains(key)) throw MisplacedValue{key, "does not go with \"concatenate\"; remove one of the two"};
    }
    signature.parts = parts_of(settings.at("concatenate"), names);
    return signature;
  }
  signature.field = at("field", [&] { return make_field(settings.at("field")); });
  signature.histogram = at("histogram", [&] { return histogram_of(settings.at("histogram")); });
  return signature;
}

std::vector<SignatureConfiguration> signatures_of(const Json& settings) {
  const std::vector<std::string> names = unique_names(settings);
  std::vector<SignatureConfiguration> signatures;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    signatures.push_back(at(std::to_string(i), [&] { return signature_of(settings[i], names); }));
  }
  if (const auto cyclic = part_of_itself(signatures)) {
    throw MisplacedValue{fmt::format("{}.concatenate", *cyclic),
                         fmt::format("the signature \"{}\" is a part of itself", names[*cyclic])};
  }
  return signatures;
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
  if (document.contains("preparation")) configuration.preparation = preparation_of(document["preparation"]);
  if (document.contains("perturbations")) configuration.perturbations = make_perturbations(document["perturbations"]);
  if (document.contains("protocol")) configuration.protocols = protocols_of(document["protocol"]);
  if (document.contains("evaluation")) {
    configuration.minimum_class_size =
        document["evaluation"].value("minimum_class_size", configuration.minimum_class_size);
  }
  configuration.on_error = document.value("on_error", "stop") == "skip" ? OnError::skip : OnError::stop;
  configuration.distance = document.value("distance", configuration.distance);
  configuration.signatures = at("signatures", [&] { return signatures_of(document.at("signatures")); });
  return configuration;
}

}  // namespace

Configuration configuration_from_json(const Json& document, const std::string& source, const fs::path& folder) {
  check_against_schema(document, source);
  try {
    return checked_configuration(document, folder);
  } catch (const MisplacedValue& error) {
    throw InputError(fmt::format("{}: {}: {}", source, error.path, printable(error.message, 500)));
  }
}

Configuration read_configuration(const fs::path& path, std::span<const std::string> overrides) {
  Json document = read_json(path);
  for (const std::string& assignment : overrides) apply_override(document, assignment);
  return configuration_from_json(document, path.string(), path.parent_path());
}

}  // namespace shapegauge
