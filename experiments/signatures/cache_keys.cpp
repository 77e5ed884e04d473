// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/cache_keys.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/version.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/engine/build_information.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/pages/coarse_view.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// Cache version of the entries' contents; see docs/manual/cache.md.
constexpr int entry_version = 4;

/// Returns the program that computes results.
const Json& program() {
  static const Json program{{"shapegauge", version()},    {"compiler", compiler()},
                            {"build_type", build_type()}, {"libraries", Json::parse(library_versions())},
                            {"processor", processor()},   {"entry_version", entry_version}};
  return program;
}

}  // namespace

std::string result_key(EntryKind kind, const Json& depends_on) {
  Json inputs = depends_on;
  inputs["kind"] = name_of(kind);
  inputs["program"] = program();
  // Keys of objects are sorted, and numbers are shortest texts that restore them.
  return sha256(json_text(inputs));
}

std::string segmentation_key(const ModelSource& source, const SegmentationMethod& method, const Json& versions,
                             const SegmentationExperiment& experiment) {
  Json settings = to_json(method);
  settings.erase("name");
  Json depends_on{{"file", source.sha256},
                  {"extension", lower_case(source.file.extension().string())},
                  {"method", std::move(settings)},
                  {"versions", {shape_reading_version, versions}}};
  if (!method.perturbations.empty()) {
    depends_on["perturbed"] = {versions_of(method.perturbations), experiment.seed, sha256(source.id), source.index};
  }
  if (experiment.preparation != PreparationOptions()) {
    depends_on["prepared"] = {to_json(experiment.preparation), preparation_version};
  }
  return result_key(EntryKind::segmentation, depends_on);
}

std::string shape_key(const ModelSource& source, const PreparationOptions& preparation,
                      const std::vector<Perturbation>& perturbations, std::uint64_t seed) {
  Json depends_on{{"file", source.sha256},
                  {"extension", lower_case(source.file.extension().string())},
                  {"preparation", to_json(preparation)},
                  {"versions", {shape_reading_version, preparation_version, diagnostics_version}}};
  if (!perturbations.empty()) {
    depends_on["perturbations"] = to_json(perturbations);
    depends_on["perturbed"] = {versions_of(perturbations), seed, sha256(source.id), source.index};
  }
  return result_key(EntryKind::shape, depends_on);
}

std::string comparison_key(const std::vector<std::string>& fields,
                           const std::vector<HistogramConfiguration>& histograms, const std::string& reference,
                           int version, int threads) {
  Json settings = Json::array();
  for (const HistogramConfiguration& histogram : histograms) settings.push_back(to_json(histogram));
  return result_key(EntryKind::comparison, {{"fields", fields},
                                            {"histograms", std::move(settings)},
                                            {"reference", reference},
                                            {"versions", {version, histogram_version}},
                                            {"threads", threads}});
}

std::string samples_key(const std::string& shape, const SamplePlan& plan) {
  return result_key(EntryKind::samples, {{"shape", shape}, {"plan", to_json(plan)}, {"version", samples_version}});
}

std::string field_key(const std::string& shape, const Field& field) {
  return result_key(EntryKind::field, {{"samples", samples_key(shape, field.settings.samples)},
                                       {"settings", to_json(field.settings)},
                                       {"versions", field.versions}});
}

std::string features_key(const std::string& shape, const DescriptorChoice& choice,
                         const std::vector<std::string>& fields, const std::string& learnt) {
  return result_key(EntryKind::features, {{"shape", shape},
                                          {"fields", fields},
                                          {"learnt", learnt},
                                          {"settings", to_json(choice)},
                                          {"versions", {choice.descriptor.version, samples_version}}});
}

std::string learnt_key(const DescriptorChoice& choice, const std::vector<std::vector<std::string>>& fields) {
  return result_key(EntryKind::learnt,
                    {{"fields", fields}, {"settings", to_json(choice)}, {"version", choice.descriptor.version}});
}

std::string distance_of(const Descriptor& descriptor) {
  return fmt::format("descriptor {} {}", descriptor.name, descriptor.version);
}

std::string picture_key(const std::string& field, const PictureOptions& options, const Eigen::Vector3d& up) {
  return result_key(EntryKind::picture, {{"field", field},
                                         {"range", {options.range.low, options.range.high}},
                                         {"size", {options.width, options.height}},
                                         {"up", {up[0], up[1], up[2]}},
                                         {"version", picture_version}});
}

std::string view_key(const std::vector<std::string>& fields, const ShapeDrawing& drawing) {
  return result_key(EntryKind::view, {{"fields", fields},
                                      {"faces", drawing.faces},
                                      {"up", {drawing.up[0], drawing.up[1], drawing.up[2]}},
                                      {"versions", {model_view_version, coarse_shape_version}}});
}

std::string distances_key(const Signatures& signatures, const std::string& distance) {
  const auto bytes = static_cast<std::size_t>(signatures.size()) * sizeof(float);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): access to the bytes is intended
  const std::string_view numbers(reinterpret_cast<const char*>(signatures.data()), bytes);
  return result_key(EntryKind::distances, {{"signatures", sha256(numbers)},
                                           {"size", {signatures.rows(), signatures.cols()}},
                                           {"distance", distance},
                                           {"version", distances_version}});
}

}  // namespace shapegauge
