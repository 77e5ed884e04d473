#include "shapegauge/experiments/configuration/configuration.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/field_settings.h"

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
  if (!report.wanted) return false;
  if (!report.pictures) return {{"pictures", false}};
  const Interval& range = report.picture_options.range;
  return {{"pictures",
           {{"of", configuration.signatures[report.pictured_signature].name}, {"range", {range.low, range.high}}}},
          {"views", report.views}};
}

Json evaluation_to_json(const Configuration& configuration) {
  Json measures = Json::array();
  for (const Measure& measure : configuration.measures) measures.push_back(measure.name);
  return {{"measures", std::move(measures)},
          {"ties", name_of(configuration.ties)},
          {"minimum_class_size", configuration.minimum_class_size}};
}

constexpr std::array<std::string_view, 2> reactions{"stop", "skip"};
constexpr std::array<std::string_view, 2> scales{"area", "tube_area"};

}  // namespace

std::span<const Parameter> experiment_parameters() {
  static const std::array parameters{
      Parameter{.name = "seed",
                .kind = ParameterKind::integer,
                .default_value = std::int64_t{1},
                .bounds = seed_bounds,
                .description = "Seed of the perturbations. Random numbers depend on the seed and on the model's id (in "
                               "comparisons, the shape's name)."},
      Parameter{.name = "on_error",
                .kind = ParameterKind::choice,
                .default_value = reactions[0],
                .choices = reactions,
                .description = "Action for an unusable model or shape: stop the run, or skip it and list it at the "
                               "end. A model that is unusable for some methods only is kept for the others."}};
  return parameters;
}

std::span<const Parameter> histogram_parameters() {
  static const std::array parameters{
      Parameter{.name = "bins",
                .kind = ParameterKind::integer,
                .default_value = std::int64_t{HistogramOptions{}.bins},
                .bounds = {.low = 1, .high = 100'000},
                .description = "Number of bins."},
      Parameter{.name = "smoothing_bins",
                .default_value = HistogramOptions{}.smoothing_bins,
                .bounds = {.low = 0, .high = 1000},
                .description = "Standard deviation of a Gaussian that smooths the histogram; at most the number of "
                               "bins; 0: none.",
                .unit = "bins"}};
  return parameters;
}

std::span<const Parameter> evaluation_parameters() {
  static const std::vector<std::string> names = ties_names();
  static const std::vector<std::string_view> ties(names.begin(), names.end());
  static const std::array parameters{
      Parameter{.name = "ties",
                .kind = ParameterKind::choice,
                .default_value = ties[0],
                .choices = ties,
                .description = "Order of models at equal distance: by index, relevant models first or last, or the "
                               "mean over all orders."},
      Parameter{.name = "minimum_class_size",
                .kind = ParameterKind::integer,
                .default_value = std::int64_t{2},
                .bounds = {.low = 2, .high = 1'000'000},
                .description = "Minimum class size of queries (psbTable of the Princeton Shape Benchmark: 3)."}};
  return parameters;
}

std::span<const Parameter> preparation_parameters() {
  static const std::array parameters{
      Parameter{
          .name = "denoise",
          .kind = ParameterKind::boolean,
          .default_value = PreparationOptions{}.denoise,
          .description =
              "Smooth clearly noisy meshes, in proportion to their noise; clean meshes and clouds are unchanged."},
      Parameter{.name = "scale",
                .kind = ParameterKind::choice,
                .default_value = scales[0],
                .choices = scales,
                .description =
                    "area: to unit surface area (clouds: estimated area); tube_area: to unit area, estimated from "
                    "the volume of a tube about the surface, which is robust to noise, cracks and sampling."}};
  return parameters;
}

const Field* pictured_field(const SignatureConfiguration& signature) {
  if (signature.field) return &*signature.field;
  if (signature.descriptor && !signature.descriptor->fields.empty()) return &signature.descriptor->fields.front();
  return nullptr;
}

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
      json["field"] = to_json(signature.field->settings);
      json["histogram"] = to_json(signature.histogram);
    } else if (signature.descriptor) {
      json["descriptor"] = signature.descriptor->settings;
    } else if (signature.derived) {
      json.update(signature.derived->settings);
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
            {"keep_distances", configuration.keep_distances},
            {"report", report_to_json(configuration)}};
  if (!configuration.description.empty()) json["description"] = configuration.description;
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

Json to_json(const PreparationOptions& preparation) {
  return {{"denoise", preparation.denoise}, {"scale", preparation.scale == ScaleEstimate::area ? "area" : "tube_area"}};
}

}  // namespace shapegauge
