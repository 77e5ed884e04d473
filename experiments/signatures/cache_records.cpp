#include "shapegauge/experiments/signatures/cache_records.h"

#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/version.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/engine/build_information.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/pages/coarse_view.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// Cache version of the entries' contents; see docs/manual/cache.md.
constexpr int entry_version = 1;

/// Returns the program that computes results.
const Json& program() {
  static const Json program{{"shapegauge", version()},    {"compiler", compiler()},
                            {"build_type", build_type()}, {"libraries", Json::parse(library_versions())},
                            {"processor", processor()},   {"entry_version", entry_version}};
  return program;
}

Json versions_of(const std::vector<Perturbation>& steps) {
  Json versions = Json::object();
  for (const Perturbation& step : steps) versions.update(step.versions);
  return versions;
}

std::string key_of(EntryKind kind, Json depends_on) {
  depends_on["kind"] = name_of(kind);
  depends_on["program"] = program();
  // Keys of objects are sorted, and numbers are shortest texts that restore them.
  return sha256(depends_on.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// Fails to compile if a member is added to ShapeDiagnostics: it must be listed above, too.
[[maybe_unused]] void all_members_are_named(const ShapeDiagnostics& diagnostics) {
  [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u] = diagnostics;
}

template <typename Number>
Json binary(const Number* numbers, Eigen::Index count) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(count) * sizeof(Number));
  if (count > 0) std::memcpy(bytes.data(), numbers, bytes.size());
  return Json::binary(std::move(bytes));
}

template <typename Vector>
Vector read_binary(const Json& record) {
  using Number = typename Vector::Scalar;
  const auto& bytes = record.get_binary();
  Vector numbers(static_cast<Eigen::Index>(bytes.size() / sizeof(Number)));
  if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size() / sizeof(Number) * sizeof(Number));
  return numbers;
}

Json facts_record(const FieldDescription& field) {
  Json record{{"range", {field.range.low, field.range.high}}, {"outcomes", field.outcomes}, {"seconds", field.seconds}};
  if (field.offset) record["offset"] = *field.offset;
  return record;
}

FieldDescription read_facts(const Json& record) {
  FieldDescription field;
  field.range = {.low = record.at("range").at(0), .high = record.at("range").at(1)};
  record.at("outcomes").get_to(field.outcomes);
  record.at("seconds").get_to(field.seconds);
  if (record.contains("offset")) field.offset = record.at("offset").get<double>();
  return field;
}

}  // namespace

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
  return key_of(EntryKind::segmentation, std::move(depends_on));
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
  return key_of(EntryKind::shape, std::move(depends_on));
}

std::string comparison_key(const std::vector<std::string>& histograms, const std::string& reference, int version,
                           int threads) {
  return key_of(EntryKind::comparison,
                {{"histograms", histograms}, {"reference", reference}, {"version", version}, {"threads", threads}});
}

std::string samples_key(const std::string& shape, const SamplePlan& plan) {
  return key_of(EntryKind::samples, {{"shape", shape}, {"plan", to_json(plan)}, {"version", samples_version}});
}

std::string field_key(const std::string& shape, const Field& field) {
  return key_of(EntryKind::field, {{"samples", samples_key(shape, field.settings.samples)},
                                   {"settings", to_json(field.settings)},
                                   {"versions", field.versions}});
}

std::string histogram_key(const std::string& field, const HistogramConfiguration& histogram) {
  return key_of(EntryKind::histogram,
                {{"field", field}, {"settings", to_json(histogram)}, {"version", histogram_version}});
}

std::string features_key(const std::string& shape, const DescriptorChoice& choice,
                         const std::vector<std::string>& fields, const std::string& learnt) {
  return key_of(EntryKind::features, {{"shape", shape},
                                      {"fields", fields},
                                      {"learnt", learnt},
                                      {"settings", choice.settings},
                                      {"versions", {choice.descriptor.version, samples_version}}});
}

std::string learnt_key(const DescriptorChoice& choice, const std::vector<std::vector<std::string>>& fields) {
  return key_of(EntryKind::learnt,
                {{"fields", fields}, {"settings", choice.settings}, {"version", choice.descriptor.version}});
}

std::string distance_of(const Descriptor& descriptor) {
  return fmt::format("descriptor {} {}", descriptor.name, descriptor.version);
}

std::string picture_key(const std::string& field, const PictureOptions& options) {
  return key_of(EntryKind::picture, {{"field", field},
                                     {"range", {options.range.low, options.range.high}},
                                     {"size", {options.width, options.height}},
                                     {"version", picture_version}});
}

std::string view_key(const std::vector<std::string>& fields, Eigen::Index faces) {
  return key_of(EntryKind::view,
                {{"fields", fields}, {"faces", faces}, {"versions", {model_view_version, coarse_shape_version}}});
}

std::string distances_key(const Signatures& signatures, const std::string& distance) {
  const auto bytes = static_cast<std::size_t>(signatures.size()) * sizeof(float);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): access to the bytes is intended
  const std::string_view numbers(reinterpret_cast<const char*>(signatures.data()), bytes);
  return key_of(EntryKind::distances, {{"signatures", sha256(numbers)},
                                       {"size", {signatures.rows(), signatures.cols()}},
                                       {"distance", distance},
                                       {"version", distances_version}});
}

// All members by name: one missing here would be restored from the cache as zero.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ShapeDiagnostics, vertices, unreferenced_vertices, coincident_vertices, diagonal,
                                   triangles, area, degenerate_triangles, duplicate_triangles, components, closed,
                                   edges, boundary_edges, boundary_length, non_manifold_edges, inconsistent_edges,
                                   gap_size, closable_gap, outliers, point_spacing, noise_deviation, noisy)

Json numbers_record(const Eigen::VectorXd& numbers) { return binary(numbers.data(), numbers.size()); }
Eigen::VectorXd read_numbers(const Json& record) { return read_binary<Eigen::VectorXd>(record); }

Json shape_record(const ModelDescription& model) {
  Json record{{"diagnostics", model.diagnostics},
              {"chosen", model.chosen},
              {"area", model.area},
              {"noise", model.noise},
              {"pass_band", model.pass_band}};
  if (!model.remarks.empty()) record["remarks"] = model.remarks;
  return record;
}

ModelDescription read_shape_record(const Json& record) {
  ModelDescription model;
  record.at("diagnostics").get_to(model.diagnostics);
  record.at("chosen").get_to(model.chosen);
  model.remarks = record.value("remarks", model.remarks);
  record.at("area").get_to(model.area);
  record.at("noise").get_to(model.noise);
  record.at("pass_band").get_to(model.pass_band);
  return model;
}

Json field_record(const CachedField& field) {
  return {{"facts", facts_record(field.facts)}, {"values", numbers_record(field.values)}};
}

CachedField read_field_record(const Json& record) {
  return {.facts = read_facts(record.at("facts")), .values = read_numbers(record.at("values"))};
}

Json histogram_record(const CachedHistogram& histogram) {
  return {{"facts", facts_record(histogram.facts)}, {"bins", binary(histogram.bins.data(), histogram.bins.size())}};
}

CachedHistogram read_histogram_record(const Json& record) {
  return {.facts = read_facts(record.at("facts")), .bins = read_binary<Eigen::VectorXf>(record.at("bins"))};
}

std::string described_bytes(const ModelDescription& model) {
  Json record{{"sha256", model.sha256},
              {"shape", shape_record(model)},
              {"picture", picture_record(model.picture)},
              {"view", view_record(model.view)}};
  for (const FieldDescription& field : model.fields) {
    record["fields"].push_back(facts_record(field));
    record["field_errors"].push_back(field.error);
  }
  for (const FeatureDescription& features : model.features) record["seconds"].push_back(features.seconds);
  const std::vector<std::uint8_t> bytes = Json::to_cbor(record);
  return {bytes.begin(), bytes.end()};
}

ModelDescription read_described(std::string_view bytes) {
  const Json record = Json::from_cbor(bytes);
  ModelDescription model = read_shape_record(record.at("shape"));
  model.sha256 = record.at("sha256");
  model.picture = read_picture(record.at("picture"));
  model.view = read_view(record.at("view"));
  const Json none = Json::array();
  for (const Json& facts : record.value("fields", none)) {
    const std::size_t field = model.fields.size();
    model.fields.push_back(read_facts(facts));
    model.fields.back().error = record.at("field_errors").at(field);
  }
  for (const Json& seconds : record.value("seconds", none)) {
    model.features.push_back({.features = {}, .seconds = seconds});
  }
  return model;
}

Json features_record(const FeatureDescription& features) {
  return {{"features", binary(features.features.data(), features.features.size())}, {"seconds", features.seconds}};
}

FeatureDescription read_features(const Json& record) {
  return {.features = read_binary<Eigen::VectorXf>(record.at("features")), .seconds = record.at("seconds")};
}

Json learnt_record(const LearntFeatures& learnt) {
  return {{"rows", learnt.rows()}, {"numbers", binary(learnt.data(), learnt.size())}};
}

LearntFeatures read_learnt(const Json& record) {
  const auto numbers = read_binary<Eigen::VectorXf>(record.at("numbers"));
  const auto rows = record.at("rows").get<Eigen::Index>();
  if (rows < 1 || numbers.size() % rows != 0) return {};
  return Eigen::Map<const LearntFeatures>(numbers.data(), rows, numbers.size() / rows);
}

Json picture_record(std::string_view png) { return Json::binary({png.begin(), png.end()}); }

std::string read_picture(const Json& record) {
  const auto& bytes = record.get_binary();
  return {bytes.begin(), bytes.end()};
}

Json view_record(const std::string& view) { return view; }
std::string read_view(const Json& record) { return record.get<std::string>(); }

Json distances_record(const DistanceMatrix& distances) {
  return {{"rows", distances.rows()}, {"numbers", binary(distances.data(), distances.size())}};
}

DistanceMatrix read_distances(const Json& record) {
  const Eigen::VectorXd numbers = read_numbers(record.at("numbers"));
  const auto rows = record.at("rows").get<Eigen::Index>();
  if (rows < 1 || numbers.size() != rows * rows) return {};
  return Eigen::Map<const DistanceMatrix>(numbers.data(), rows, rows);
}

}  // namespace shapegauge
