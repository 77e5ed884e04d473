#include "shapegauge/experiments/shape_comparison/measurement_records.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "shapegauge/experiments/signatures/cache_records.h"

namespace shapegauge {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ValueErrors, median, percentile_90, relative_median, relative_percentile_90)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NormalErrors, mean, median, percentile_90)

namespace {

template <typename Errors>
void add_errors(const char* key, const std::optional<Errors>& errors, Json& record) {
  if (errors) record[key] = *errors;
}

template <typename Errors>
void read_errors(const char* key, const Json& record, std::optional<Errors>& errors) {
  if (record.contains(key)) errors = record.at(key).get<Errors>();
}

Json measurement_record(const FieldMeasurement& measurement) {
  Json record{{"samples", measurement.samples},
              {"missing", measurement.missing},
              {"build_seconds", measurement.build_seconds},
              {"query_seconds", measurement.query_seconds}};
  add_errors("errors", measurement.errors, record);
  add_errors("offset_normals", measurement.offset_normals, record);
  add_errors("own_normals", measurement.own_normals, record);
  return record;
}

FieldMeasurement read_measurement(const Json& record) {
  FieldMeasurement measurement;
  record.at("samples").get_to(measurement.samples);
  record.at("missing").get_to(measurement.missing);
  record.at("build_seconds").get_to(measurement.build_seconds);
  record.at("query_seconds").get_to(measurement.query_seconds);
  read_errors("errors", record, measurement.errors);
  read_errors("offset_normals", record, measurement.offset_normals);
  read_errors("own_normals", record, measurement.own_normals);
  return measurement;
}

/// Record of a matrix of three columns.
template <typename Matrix>
Json columns_record(const Matrix& matrix) {
  return numbers_record(matrix.template cast<double>().reshaped());
}

template <typename Matrix>
Matrix read_columns(const Json& record) {
  const Eigen::VectorXd numbers = read_numbers(record);
  return numbers.reshaped(numbers.size() / 3, 3).template cast<typename Matrix::Scalar>();
}

Json reference_record(const ReferenceShape& reference) {
  Json record{{"key", reference.key},
              {"vertices", columns_record(reference.shape.vertices)},
              {"triangles", columns_record(reference.shape.triangles)}};
  for (const PlacedValues& placed : reference.values) {
    record["values"].push_back({{"points", columns_record(placed.points)}, {"values", numbers_record(placed.values)}});
  }
  return record;
}

ReferenceShape read_reference(const Json& record, std::span<const PlannedField> plan) {
  ReferenceShape reference =
      make_reference(record.at("key"), {.vertices = read_columns<Points>(record.at("vertices")),
                                        .triangles = read_columns<Triangles>(record.at("triangles"))});
  for (std::size_t field = 0; field < plan.size(); ++field) {
    const Json& placed = record.at("values").at(field);
    reference.values.push_back({.points = read_columns<Points>(placed.at("points")),
                                .values = read_numbers(placed.at("values")),
                                .dimension = plan[field].field.dimension});
  }
  return reference;
}

}  // namespace

Json measured_record(const MeasuredShape& measured) {
  Json record{{"shape", shape_record(measured.description)},
              {"read_seconds", measured.read_seconds},
              {"fields", Json::array()},
              {"histograms", Json::array()}};
  for (std::size_t i = 0; i < measured.fields.size(); ++i) {
    const FieldDescription& field = measured.description.fields[i];
    record["fields"].push_back({{"field", field_record({.facts = field, .values = field.values.cast<double>()})},
                                {"weights", numbers_record(field.weights.cast<double>())},
                                {"measured", measurement_record(measured.fields[i])}});
  }
  for (const Eigen::VectorXf& histogram : measured.description.histograms) {
    record["histograms"].push_back(numbers_record(histogram.cast<double>()));
  }
  if (measured.reference) record["reference"] = reference_record(*measured.reference);
  return record;
}

MeasuredShape read_measured_record(const Json& record, std::span<const PlannedField> plan) {
  MeasuredShape measured;
  measured.description = read_shape_record(record.at("shape"));
  record.at("read_seconds").get_to(measured.read_seconds);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Json& one = record.at("fields").at(i);
    CachedField cached = read_field_record(one.at("field"));
    FieldDescription& field = measured.description.fields.emplace_back(std::move(cached.facts));
    field.values = cached.values.cast<float>();
    field.weights = read_numbers(one.at("weights")).cast<float>();
    measured.fields.push_back(read_measurement(one.at("measured")));
  }
  for (const Json& histogram : record.at("histograms")) {
    measured.description.histograms.emplace_back(read_numbers(histogram).cast<float>());
  }
  if (record.contains("reference")) measured.reference = read_reference(record.at("reference"), plan);
  return measured;
}

std::string measured_bytes(const MeasuredShape& measured) {
  const std::vector<std::uint8_t> bytes = Json::to_cbor(measured_record(measured));
  return {bytes.begin(), bytes.end()};
}

MeasuredShape read_measured_bytes(std::string_view bytes, std::span<const PlannedField> plan) {
  return read_measured_record(Json::from_cbor(bytes), plan);
}

}  // namespace shapegauge
