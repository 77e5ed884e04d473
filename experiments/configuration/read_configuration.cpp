// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/read_configuration.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/dataset_files.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/configuration/short_forms.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

bool has_field(const SignatureConfiguration& signature) { return pictured_field(signature) != nullptr; }

std::size_t signature_named(const std::string& name, const std::vector<SignatureConfiguration>& signatures) {
  std::vector<std::string> names;
  for (const SignatureConfiguration& signature : signatures) names.push_back(signature.name);
  const std::size_t found = index_of_name(name, names, "signature", "pictures.of");
  if (has_field(signatures[found])) return found;
  throw ConfigurationError{"pictures.of",
                           fmt::format("the signature \"{}\" has no field of its own; choose one that has", name)};
}

/// Reads a list of two numbers. `path` is its position in messages.
Interval read_range(const char* path, const Json& range) {
  const Interval interval{.low = range.at(0), .high = range.at(1)};
  if (interval.low < interval.high) return interval;
  throw ConfigurationError{path, fmt::format("the first value must be less than the second, not {}", range.dump())};
}

/// Reads the setting "report" of a retrieval experiment with these signatures. Throws ConfigurationError for pictures
/// of a signature that does not exist or has no field of its own, and for a range of no width.
ReportConfiguration read_report(const Json& setting, const std::vector<SignatureConfiguration>& signatures) {
  ReportConfiguration report;
  const auto first = std::ranges::find_if(signatures, has_field);
  report.pictured_signature = static_cast<std::size_t>(first - signatures.begin());
  if (setting.is_boolean()) report.enabled = setting;
  const Json pictures = setting.is_object() ? setting.value("pictures", Json(true)) : Json(report.enabled);
  report.pictures = pictures != Json(false) && first != signatures.end();
  report.views = report.pictures && (!setting.is_object() || setting.value("views", true));
  if (setting.is_object()) report.up = value_of_word<UpAxis>(setting.value("up", name_of(report.up))).value();
  if (!pictures.is_object()) return report;
  if (pictures.contains("of")) report.pictured_signature = signature_named(pictures.at("of"), signatures);
  if (pictures.contains("range")) report.picture_options.range = read_range("pictures.range", pictures.at("range"));
  return report;
}

HistogramConfiguration histogram_of(const Json& settings) {
  HistogramConfiguration histogram;
  histogram.options = read_options(histogram_table, settings);
  if (histogram.options.smoothing_bins > histogram.options.bins) {
    throw ConfigurationError{"smoothing_bins", fmt::format("must be at most the number of bins, {}, not {}",
                                                           histogram.options.bins, histogram.options.smoothing_bins)};
  }
  const Json& range = settings.at("range");
  if (range.is_string()) {
    histogram.range = value_of_word<HistogramRange>(range.get<std::string>()).value();
    return histogram;
  }
  const char* path = range.is_object() ? "range.fixed" : "range";
  histogram.range = HistogramRange::fixed;
  histogram.fixed = read_range(path, range.is_object() ? range.at("fixed") : range);
  if (!std::isfinite(histogram.fixed.high - histogram.fixed.low)) {
    throw ConfigurationError{path, fmt::format("the values are too far apart: {}", range.dump())};
  }
  return histogram;
}

/// Returns the path of a name in the list of names at a key: "sum.1.of".
std::string path_of_name(const std::string& key, std::size_t index) {
  if (key == "rerank") return "rerank.of";
  return fmt::format("{}.{}{}", key, index, key == "sum" ? ".of" : "");
}

/// Returns the signatures listed by name in the setting of that key.
std::vector<std::size_t> parts_of(const std::string& key, const std::vector<std::string>& listed,
                                  const std::vector<std::string>& names) {
  std::vector<std::size_t> parts;
  for (const std::string& name : listed) {
    parts.push_back(index_of_name(name, names, "signature", path_of_name(key, parts.size())));
  }
  return parts;
}

/// Returns the settings that define the kind of a signature; a histogram has two of them.
std::vector<std::string> keys_of_kinds() {
  std::vector<std::string> keys{"concatenate", "descriptor"};
  for (const std::string_view key : derived_keys()) keys.emplace_back(key);
  return keys;
}

/// Returns the setting that defines the kind of a signature other than a histogram. Throws ConfigurationError for
/// several.
std::optional<std::string> kind_of(const Json& settings) {
  std::optional<std::string> kind;
  for (const std::string& key : keys_of_kinds()) {
    if (!settings.contains(key)) continue;
    if (kind)
      throw ConfigurationError{key, fmt::format("cannot be combined with \"{}\"; remove one of the two", *kind)};
    kind = key;
  }
  for (const char* key : {"field", "histogram"}) {
    if (kind && settings.contains(key)) {
      throw ConfigurationError{key, fmt::format("cannot be combined with \"{}\"; remove one of the two", *kind)};
    }
  }
  return kind;
}

SignatureConfiguration signature_of(const Json& settings, const std::vector<std::string>& names) {
  SignatureConfiguration signature;
  signature.name = settings.at("name");
  const std::optional<std::string> kind = kind_of(settings);
  if (kind == "concatenate") {
    signature.parts = parts_of(*kind, settings.at(*kind), names);
    return signature;
  }
  if (kind == "descriptor") {
    signature.descriptor = at_key(*kind, [&] { return make_descriptor(settings.at(*kind)); });
    return signature;
  }
  if (kind) {
    try {
      signature.derived = make_derived(*kind, settings);
    } catch (const ConfigurationError&) {
      throw;
    } catch (const InputError& error) {
      throw ConfigurationError{*kind, error.what()};
    }
    signature.parts = parts_of(*kind, signature.derived->names, names);
    return signature;
  }
  signature.field = at_key("field", [&] { return read_field(settings.at("field")); });
  signature.histogram = at_key("histogram", [&] { return histogram_of(settings.at("histogram")); });
  return signature;
}

/// Throws unless all parts of concatenations are histograms or made of histograms.
void require_histograms(const std::vector<SignatureConfiguration>& signatures) {
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    const auto& parts = signatures[i].parts;
    for (std::size_t k = 0; !signatures[i].derived && k < parts.size(); ++k) {
      const SignatureConfiguration& part = signatures[parts[k]];
      if (!part.descriptor && !part.derived) continue;
      throw ConfigurationError{
          fmt::format("{}.concatenate.{}", i, k),
          fmt::format("the signature \"{}\" is no histogram of a field; use \"sum\" for it", part.name)};
    }
  }
}

std::vector<Protocol> protocols_of(const Json& setting) {
  std::vector<Protocol> protocols;
  const auto add = [&](const Json& name) {
    protocols.push_back(value_of_word<Protocol>(name.get<std::string>()).value());
  };
  if (setting.is_array()) {
    std::ranges::for_each(setting, add);
  } else {
    add(setting);
  }
  return protocols;
}

EvaluationOptions read_evaluation(const Json& setting, const std::vector<Protocol>& protocols) {
  EvaluationOptions options = read_options(evaluation_table, setting);
  options.measures = default_measures(protocols);
  if (!setting.contains("measures")) return options;
  try {
    options.measures = measures_of(setting["measures"].get<std::vector<std::string>>());
  } catch (const ArgumentError& error) {
    throw ConfigurationError{"measures", error.what()};
  }
  return options;
}

/// Reads a document that the schema has accepted.
Configuration checked_configuration(const Json& document, const fs::path& folder) {
  Configuration configuration;
  read_shared_settings(document, configuration);
  const Json& dataset = document.at("dataset");
  if (dataset.contains("generate")) {
    configuration.generator = at_key("dataset", [&] { return read_generator(dataset); });
  } else {
    configuration.location = at_key("dataset", [&] { return read_location(dataset, folder); });
  }
  if (document.contains("perturbations")) configuration.perturbations = make_perturbations(document["perturbations"]);
  if (document.contains("protocol")) configuration.protocols = protocols_of(document["protocol"]);
  configuration.evaluation = at_key("evaluation", [&] {
    return read_evaluation(document.value("evaluation", Json::object()), configuration.protocols);
  });
  configuration.distance = document.value("distance", configuration.distance);
  configuration.keep_distances = document.value("keep_distances", configuration.keep_distances);
  configuration.signatures = at_key("signatures", [&] { return read_signatures(document.at("signatures")); });
  configuration.report =
      at_key("report", [&] { return read_report(document.value("report", Json(true)), configuration.signatures); });
  return configuration;
}

}  // namespace

std::vector<std::string> unique_names(const Json& entries, std::string_view list) {
  std::vector<std::string> names;
  for (const Json& entry : entries) {
    const std::string name = entry.at("name");
    const auto earlier = std::ranges::find(names, name);
    if (earlier != names.end()) {
      throw ConfigurationError{
          fmt::format("{}.name", names.size()),
          fmt::format("the name \"{}\" is already that of {}.{}", name, list, earlier - names.begin())};
    }
    names.push_back(name);
  }
  return names;
}

std::size_t index_of_name(const std::string& name, const std::vector<std::string>& names, std::string_view noun,
                          const std::string& path) {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw ConfigurationError{path, fmt::format("there is no {} \"{}\"{}", noun, name, suggestion(name, names))};
}

std::vector<SignatureConfiguration> read_signatures(const Json& settings) {
  const std::vector<std::string> names = unique_names(settings, "signatures");
  std::vector<SignatureConfiguration> signatures;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    signatures.push_back(at_key(std::to_string(i), [&] { return signature_of(settings[i], names); }));
  }
  if (const auto cyclic = find_cyclic_signature(signatures)) {
    const auto& derived = signatures[*cyclic].derived;
    throw ConfigurationError{
        fmt::format("{}.{}", *cyclic, derived ? key_of(*derived) : "concatenate"),
        fmt::format("the signature \"{}\" refers to itself, directly or through others; remove one reference",
                    names[*cyclic])};
  }
  require_histograms(signatures);
  return signatures;
}

void read_shared_settings(const Json& document, ExperimentSettings& settings) {
  const ParameterValues values = read_parameters(experiment_parameters(), document);
  settings = {.name = document.at("name"),
              .description = document.value("description", ""),
              .seed = static_cast<std::uint64_t>(values.integer("seed")),
              .preparation = read_options(preparation_table, document.value("preparation", Json::object())),
              .on_error = member_value<OnError>(values.value("on_error"))};
}

DatasetLocation read_location(const Json& dataset, const fs::path& folder) {
  DatasetLocation location;
  location.layout = dataset.at("layout");
  location.root = path_value(dataset, "root", folder);
  const DatasetLayout& layout = dataset_layouts().at(location.layout);
  if (dataset.contains("split")) {
    if (!layout.has_splits) {
      throw ConfigurationError{"split", fmt::format("the layout \"{}\" has no splits; remove it", location.layout)};
    }
    location.split = dataset.at("split");
  }
  if (!layout.has_classification) {
    if (!dataset.contains("classification")) return location;
    throw ConfigurationError{
        "classification",
        fmt::format("the layout \"{}\" has its classes in names of files or folders", location.layout)};
  }
  location.classification = dataset.contains("classification") ? path_value(dataset, "classification", location.root)
                                                               : location.root / layout.default_classification;
  return location;
}

GeneratorOptions read_generator(const Json& dataset) {
  for (const auto& [key, value] : dataset.items()) {
    if (key != "generate") {
      throw ConfigurationError{key, "cannot be combined with \"generate\"; remove one of the two"};
    }
  }
  return at_key("generate", [&] { return read_options(generator_table(), dataset.at("generate")); });
}

Configuration configuration_from_json(const Json& json, const std::string& source, const fs::path& folder) {
  Json document = json;
  read_dataset_files(document, source, folder, retrieval_paths().datasets);
  expand_short_forms(document);
  check_against_schema(document, "retrieval_experiment", source);
  return with_source(source, [&] { return checked_configuration(document, folder); });
}

namespace {

/// Returns the positions of paths in a document, all of which hold strings.
std::vector<Json::json_pointer> path_pointers(const Json& document, const DocumentPaths& paths) {
  std::vector<Json::json_pointer> pointers = matching_pointers(document, paths.files);
  for (const Json::json_pointer& dataset : matching_pointers(document, paths.datasets)) {
    pointers.push_back(dataset);
    pointers.push_back(dataset / "root");
  }
  std::erase_if(pointers,
                [&](const auto& pointer) { return !document.contains(pointer) || !document[pointer].is_string(); });
  return pointers;
}

bool is_at_or_below(const Json::json_pointer& pointer, const Json::json_pointer& above) {
  return (pointer.to_string() + "/").starts_with(above.to_string() + "/");
}

}  // namespace

const DocumentPaths& retrieval_paths() {
  static const DocumentPaths paths{.datasets = {"/dataset"}};
  return paths;
}

std::vector<fs::path> apply_overrides(Json& document, const std::string& source, const fs::path& folder,
                                      std::span<const std::string> overrides, const PathsOfDocument& paths_of) {
  std::vector<fs::path> files = read_dataset_files(document, source, folder, paths_of(document).datasets);
  for (const std::string& assignment : overrides) {
    const Json::json_pointer changed = apply_override(document, assignment);
    for (const Json::json_pointer& pointer : path_pointers(document, paths_of(document))) {
      if (!is_at_or_below(pointer, changed)) continue;
      const std::string path = expand_variables(document[pointer].get<std::string>());
      document[pointer] = fs::absolute(path).lexically_normal().string();
    }
  }
  return files;
}

Json read_retrieval_document(const fs::path& path, std::span<const std::string> overrides) {
  Json document = read_json(path);
  apply_overrides(document, path.string(), path.parent_path(), overrides,
                  [](const Json&) { return retrieval_paths(); });
  return document;
}

Configuration read_configuration(const fs::path& path, std::span<const std::string> overrides) {
  return configuration_from_json(read_retrieval_document(path, overrides), path.string(), path.parent_path());
}

}  // namespace shapegauge
