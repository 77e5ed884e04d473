#include "shapegauge/experiments/configuration/configuration.h"

#include <utility>

#include "shapegauge/experiments/configuration/perturbations.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

enum class Visit { not_yet, under_way, done };

/// Appends the signature after its parts; the index of a signature that is a part of itself, or nothing.
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

/// A path that names the same from any folder: a run may be repeated from elsewhere.
std::string absolute_text(const std::filesystem::path& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

Json dataset_to_json(const Configuration& configuration) {
  if (configuration.generator) return {{"generate", to_json(*configuration.generator)}};
  const DatasetLocation& location = configuration.location.value();
  Json json{{"layout", location.layout}, {"root", absolute_text(location.root)}};
  if (!location.classification.empty()) json["classification"] = absolute_text(location.classification);
  if (location.layout == "folders") json["split"] = location.split;
  return json;
}

Json report_to_json(const Configuration& configuration) {
  const ReportConfiguration& report = configuration.report;
  if (!report.wanted) return false;
  if (!report.pictures) return {{"pictures", false}};
  const Interval& range = report.picture_options.range;
  return {{"pictures",
           {{"of", configuration.signatures[report.pictured_signature].name}, {"range", {range.low, range.high}}}}};
}

}  // namespace

std::optional<std::size_t> part_of_itself(const std::vector<SignatureConfiguration>& signatures) {
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
  Json json{{"bins", histogram.options.bins}, {"smoothing_bins", histogram.options.smoothing_bins}};
  if (histogram.range == HistogramRange::fixed) {
    json["range"] = {{"fixed", {histogram.fixed.low, histogram.fixed.high}}};
  } else {
    json["range"] = histogram.range == HistogramRange::per_shape ? "per-shape" : "dataset";
  }
  return json;
}

Json to_json(const std::vector<SignatureConfiguration>& signatures) {
  Json list = Json::array();
  for (const SignatureConfiguration& signature : signatures) {
    Json json{{"name", signature.name}};
    if (signature.field) {
      json["field"] = signature.field->settings;
      json["histogram"] = to_json(signature.histogram);
    } else {
      for (const std::size_t part : signature.parts) json["concatenate"].push_back(signatures[part].name);
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json to_json(const GeneratorOptions& generator) {
  return {{"classes", generator.classes},
          {"models_per_class", generator.models_per_class},
          {"faces", generator.faces},
          {"seed", generator.seed}};
}

namespace {

Json evaluation_to_json(const Configuration& configuration) {
  Json measures = Json::array();
  for (const Measure& measure : configuration.measures) measures.push_back(measure.name);
  return {{"measures", std::move(measures)},
          {"ties", name_of(configuration.ties)},
          {"minimum_class_size", configuration.minimum_class_size}};
}

}  // namespace

Json to_json(const Configuration& configuration) {
  Json json{{"name", configuration.name},
            {"dataset", dataset_to_json(configuration)},
            {"perturbations", to_json(configuration.perturbations)},
            {"seed", configuration.seed},
            {"preparation", to_json(configuration.preparation)},
            {"evaluation", evaluation_to_json(configuration)},
            {"on_error", configuration.on_error == OnError::stop ? "stop" : "skip"},
            {"signatures", to_json(configuration.signatures)},
            {"distance", configuration.distance},
            {"report", report_to_json(configuration)}};
  if (!configuration.description.empty()) json["description"] = configuration.description;
  for (const Protocol protocol : configuration.protocols) json["protocol"].push_back(name_of(protocol));
  return json;
}

PreparationOptions read_preparation(const nlohmann::json& settings) {
  PreparationOptions preparation;
  preparation.denoise = settings.value("denoise", preparation.denoise);
  if (settings.value("scale", "area") == "tube_area") preparation.scale = ScaleEstimate::tube_area;
  return preparation;
}

nlohmann::json to_json(const PreparationOptions& preparation) {
  return {{"denoise", preparation.denoise}, {"scale", preparation.scale == ScaleEstimate::area ? "area" : "tube_area"}};
}

}  // namespace shapegauge
