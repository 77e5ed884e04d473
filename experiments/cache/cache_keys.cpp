#include "shapegauge/experiments/cache/cache_keys.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/core/shape/diagnostics.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/cache/entry_kind.h"
#include "shapegauge/experiments/cache/processor.h"
#include "shapegauge/experiments/configuration/preparation_settings.h"
#include "shapegauge/experiments/perturbations/perturbation.h"
#include "shapegauge/experiments/perturbations/perturbation_registry.h"
#include "shapegauge/experiments/results/build_information.h"
#include "shapegauge/experiments/results/sha256.h"
#include "shapegauge/experiments/text/lower_case.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// To be raised with every change of what the entries hold.
constexpr int entry_version = 1;

/// The program that computes.
const Json& program() {
  static const Json program{{"shapegauge", version()},    {"compiler", compiler()},
                            {"build_type", build_type()}, {"libraries", Json::parse(library_versions())},
                            {"processor", processor()},   {"entry_version", entry_version}};
  return program;
}

std::string key_of(EntryKind kind, Json depends_on) {
  depends_on["kind"] = name_of(kind);
  depends_on["program"] = program();
  // Keys of objects come in order, numbers as the shortest text that reads back the same.
  return sha256(depends_on.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

std::string shape_key(const ModelSource& source, const Configuration& configuration) {
  Json depends_on{{"file", source.sha256},
                  {"extension", lower_case(source.file.extension().string())},
                  {"preparation", to_json(configuration.preparation)},
                  {"versions", {shape_reading_version, preparation_version, diagnostics_version}}};
  if (!configuration.perturbations.empty()) {
    depends_on["perturbations"] = to_json(configuration.perturbations);
    depends_on["perturbed"] = {perturbations_version, configuration.seed, sha256(source.id), source.index};
  }
  return key_of(EntryKind::shape, std::move(depends_on));
}

std::string samples_key(const std::string& shape, const SamplePlan& plan) {
  return key_of(EntryKind::samples, {{"shape", shape}, {"plan", to_json(plan)}, {"version", samples_version}});
}

std::string field_key(const std::string& shape, const Field& field) {
  return key_of(
      EntryKind::field,
      {{"samples", samples_key(shape, field.samples)}, {"settings", field.settings}, {"versions", field.versions}});
}

std::string histogram_key(const std::string& field, const HistogramConfiguration& histogram) {
  return key_of(EntryKind::histogram,
                {{"field", field}, {"settings", to_json(histogram)}, {"version", histogram_version}});
}

std::string picture_key(const std::string& field, const PictureOptions& options) {
  return key_of(EntryKind::picture, {{"field", field},
                                     {"range", {options.range.low, options.range.high}},
                                     {"size", {options.width, options.height}},
                                     {"version", picture_version}});
}

std::string distances_key(const Signatures& signatures, const std::string& distance) {
  const auto bytes = static_cast<std::size_t>(signatures.size()) * sizeof(float);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the bytes of the numbers are what is wanted
  const std::string_view numbers(reinterpret_cast<const char*>(signatures.data()), bytes);
  return key_of(EntryKind::distances, {{"signatures", sha256(numbers)},
                                       {"size", {signatures.rows(), signatures.cols()}},
                                       {"distance", distance},
                                       {"version", distances_version}});
}

}  // namespace shapegauge
