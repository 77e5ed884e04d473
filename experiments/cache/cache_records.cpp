#include "shapegauge/experiments/cache/cache_records.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace shapegauge {

// By name, every member: one that is missing here would come back from the cache as zero.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ShapeDiagnostics, vertices, unreferenced_vertices, coincident_vertices, diagonal,
                                   triangles, area, degenerate_triangles, duplicate_triangles, components, closed,
                                   edges, boundary_edges, boundary_length, non_manifold_edges, inconsistent_edges,
                                   gap_size, point_spacing, noise_deviation, noisy)

namespace {

using Json = nlohmann::json;

/// The program does not compile where a member is added to ShapeDiagnostics: name it above, too.
[[maybe_unused]] void all_members_are_named(const ShapeDiagnostics& diagnostics) {
  [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = diagnostics;
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

Json numbers_record(const Eigen::VectorXd& numbers) { return binary(numbers.data(), numbers.size()); }
Eigen::VectorXd read_numbers(const Json& record) { return read_binary<Eigen::VectorXd>(record); }

Json shape_record(const ModelDescription& model) {
  return {{"diagnostics", model.diagnostics},
          {"chosen", model.chosen},
          {"area", model.area},
          {"noise", model.noise},
          {"pass_band", model.pass_band}};
}

ModelDescription read_shape_record(const Json& record) {
  ModelDescription model;
  record.at("diagnostics").get_to(model.diagnostics);
  record.at("chosen").get_to(model.chosen);
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
