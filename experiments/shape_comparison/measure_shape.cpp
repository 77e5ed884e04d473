#include "shapegauge/experiments/shape_comparison/measure_shape.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/experiments/shape_comparison/measurement_records.h"
#include "shapegauge/experiments/signatures/cache_records.h"

namespace shapegauge {

namespace {

/// Compares the normals that a field estimates, and those of the samples, with the reference's.
void compare_normals(const TrueNormals& truth, const PreparedShape& prepared, const Samples& samples,
                     const Points& estimated, FieldMeasurement& measurement) {
  const Points points = samples.points * std::sqrt(prepared.area);
  const bool sided = !is_cloud(prepared.shape) || prepared.shape.normals.rows() > 0;
  measurement.offset_normals = normal_errors(truth, points, estimated, samples.weights, true);
  measurement.own_normals = normal_errors(truth, points, samples.normals, samples.weights, sided);
}

FieldMeasurement measure_field(const Samples& samples, const FieldValues& computed) {
  FieldMeasurement measurement;
  measurement.samples = static_cast<std::size_t>(samples.points.rows());
  measurement.missing = static_cast<std::size_t>(computed.values.array().isNaN().count());
  measurement.build_seconds = computed.build_seconds;
  measurement.query_seconds = computed.query_seconds;
  return measurement;
}

/// Measures a perturbed shape. `own` is given for the reference itself: it becomes MeasuredShape::reference, with
/// values.
MeasuredShape measure_shape(const ShapeComparison& comparison, PerturbedShape perturbed,
                            std::span<const PlannedField> plan, const ReferenceShape* reference,
                            std::optional<ReferenceShape> own, const RunControl& control) {
  MeasuredShape measured;
  measured.reference = std::move(own);
  const ReferenceShape* const compared_with = measured.reference ? &*measured.reference : reference;
  const auto observe = [&](std::size_t field, const PreparedShape& prepared, const Samples& samples,
                           const FieldValues& computed) {
    if (control.interrupted()) throw Interrupted();
    FieldMeasurement& measurement = measured.fields.emplace_back(measure_field(samples, computed));
    if (compared_with == nullptr) return;
    const PlacedValues placed =
        placed_values(samples, computed.values, plan[field].field.dimension, std::sqrt(prepared.area));
    if (measured.reference) measured.reference->values.push_back(placed);
    measurement.errors = value_errors(placed, compared_with->values[field], compared_with->diagonal);
    if (compared_with->normals && computed.normals.rows() > 0) {
      compare_normals(*compared_with->normals, prepared, samples, computed.normals, measurement);
    }
  };
  measured.description =
      describe_shape(std::move(perturbed), comparison.preparation, comparison.signatures, plan, true, observe);
  return measured;
}

/// Returns what identifies the source of a shape: the hash of its file, or of the description of a generated one.
std::string source_hash(const ComparedShape& shape, const std::optional<ShapeSource>& file) {
  if (file) return sha256_of_shape(*file);
  return sha256(fmt::format("generator {} {}", generator_version, to_json(shape.generated.value()).dump()));
}

/// Returns the keys of the histograms of all signatures.
std::vector<std::string> histogram_keys(const ShapeComparison& comparison, std::span<const PlannedField> plan,
                                        const std::string& shape) {
  std::vector<std::string> keys(comparison.signatures.size());
  for (const PlannedField& planned : plan) {
    const std::string field = field_key(shape, planned.field);
    for (const std::size_t i : planned.signatures) {
      keys[i] = histogram_key(field, comparison.signatures[i].histogram);
    }
  }
  return keys;
}

}  // namespace

ReferenceShape make_reference(std::string key, Shape shape) {
  ReferenceShape reference{
      .key = std::move(key), .shape = {}, .diagonal = bounding_box_diagonal(shape), .normals = {}, .values = {}};
  if (!is_cloud(shape)) reference.normals.emplace(shape);
  reference.shape = std::move(shape);
  return reference;
}

MeasuredShape measure_through_cache(const ShapeComparison& comparison, std::size_t index,
                                    std::span<const PlannedField> plan, const ReferenceShape* reference,
                                    const RunControl& control, Cache& cache) {
  const ComparedShape& source = comparison.shapes[index];
  const bool is_compared_with = comparison.reference == index && comparison.registered;
  const Stopwatch reading;
  const std::optional<ShapeSource> file =
      source.generated ? std::nullopt : std::optional(read_shape_source(source.file));
  const double file_seconds = reading.seconds();

  const std::string hash = source_hash(source, file);
  const std::string shape = shape_key({.sha256 = hash, .file = source.file, .id = source.name, .index = index},
                                      comparison.preparation, source.perturbations, comparison.seed);
  std::string compared_with = reference != nullptr ? reference->key : "";
  if (is_compared_with) compared_with = "itself";  // its record has more contents than that of an equal shape
  const std::string key = comparison_key(histogram_keys(comparison, plan, shape), compared_with, field_errors_version,
                                         thread_count(control));
  auto found = cache.lookup(EntryKind::comparison, key,
                            [&](const nlohmann::json& record) { return read_measured_record(record, plan); });
  if (found) {
    cache.count(EntryKind::comparison, true);
    return *std::move(found);
  }

  const Stopwatch parsing;
  Shape read = file ? read_shape(*file) : generate_model(*source.generated);
  const double read_seconds = file_seconds + parsing.seconds();
  PerturbedShape perturbed = perturb_model(std::move(read), source.perturbations, comparison.seed, source.name, index);
  std::optional<ReferenceShape> own;
  if (is_compared_with) own = make_reference(shape, perturbed.shape);
  MeasuredShape measured = measure_shape(comparison, std::move(perturbed), plan, reference, std::move(own), control);
  measured.read_seconds = read_seconds;
  cache.count(EntryKind::comparison, false);
  cache.store(EntryKind::comparison, key, measured_record(measured));
  return measured;
}

}  // namespace shapegauge
