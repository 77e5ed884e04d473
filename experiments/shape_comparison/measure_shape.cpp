// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/shape_comparison/measure_shape.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/experiments/signatures/bench.h"
#include "shapegauge/experiments/signatures/cache_keys.h"

namespace shapegauge {

namespace {

/// Compares the normals that a field estimates, and those of the samples, with the reference's.
void compare_normals(const TrueNormals& truth, const PreparedShape& prepared, const Samples& samples,
                     const Points& estimated, FieldMeasurement& measurement) {
  const Points points = samples.points * std::sqrt(prepared.area);
  const bool sided = !is_cloud(prepared.shape) || prepared.shape.normals.rows() > 0;
  measurement.offset_normals = normal_errors(truth, points, estimated, samples.weights, true);
  measurement.shape_normals = normal_errors(truth, points, samples.normals, samples.weights, sided);
}

/// Counts the samples of a field, and compares its values with those of the reference, if there is one. `as_reference`
/// receives the values if the shape is the reference itself.
FieldMeasurement measure_field(const PreparedShape& prepared, const Samples& samples, const Field& field,
                               std::size_t index, const FieldValues& computed, const GroundTruth* truth,
                               ReferenceShape* as_reference) {
  FieldMeasurement measurement;
  measurement.samples = static_cast<std::size_t>(samples.points.rows());
  measurement.missing = static_cast<std::size_t>(computed.values.array().isNaN().count());
  measurement.build_seconds = computed.build_seconds;
  measurement.query_seconds = computed.query_seconds;
  if (truth == nullptr) return measurement;
  const LocatedValues located = located_values(samples, computed.values, field.dimension, std::sqrt(prepared.area));
  if (as_reference != nullptr) as_reference->values.push_back(located);
  measurement.errors = value_errors(located, truth->reference->values[index], truth->diagonal);
  if (truth->normals && computed.normals.rows() > 0) {
    compare_normals(*truth->normals, prepared, samples, computed.normals, measurement);
  }
  return measurement;
}

/// Measures a perturbed shape. `as_reference` has a value for the reference itself; it becomes
/// MeasuredShape::reference, with values.
MeasuredShape measure_shape(const ShapeComparison& comparison, PerturbedShape perturbed, std::span<const Field> fields,
                            const GroundTruth* truth, std::optional<ReferenceShape> as_reference,
                            const RunControl& control) {
  MeasuredShape measured;
  measured.reference = std::move(as_reference);
  std::optional<GroundTruth> itself;
  if (measured.reference) truth = &itself.emplace(*measured.reference);
  Cache none;  // run times are those of computing
  CachedShape bench(
      "", [&] { return std::move(perturbed); }, comparison.preparation, true, none);
  ModelDescription& description = measured.description;
  static_cast<ShapeFacts&>(description) = bench.facts();
  description.features.resize(comparison.signatures.size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Field& field = fields[i];
    const Samples& samples = bench.samples(field.settings.samples);
    FieldValues computed = bench.compute(field);
    if (control.interrupted()) throw Interrupted();
    measured.fields.push_back(measure_field(bench.prepared(), samples, field, i, computed, truth,
                                            measured.reference ? &*measured.reference : nullptr));
    description.fields.push_back(describe_field(stored_field(field, std::move(computed), samples), samples.weights,
                                                field, comparison.signatures, description.features));
  }
  return measured;
}

/// Returns what identifies the source of a shape: the hash of its file, or of the description of a generated one.
std::string source_hash(const ComparedShape& shape, const std::optional<ShapeSource>& file) {
  if (file) return sha256_of_shape(*file);
  return sha256(fmt::format("generator {} {}", generator_version, to_json(shape.generated.value()).dump()));
}

/// Returns the key of what is measured on the shape of that key.
std::string key_of_measurement(const ShapeComparison& comparison, const std::string& shape,
                               const std::string& compared_with, int threads) {
  std::vector<std::string> fields;
  std::vector<HistogramConfiguration> histograms;
  for (const SignatureConfiguration& signature : comparison.signatures) {
    fields.push_back(field_key(shape, signature.field.value()));
    histograms.push_back(signature.histogram);
  }
  return comparison_key(fields, histograms, compared_with, field_errors_version, threads);
}

}  // namespace

GroundTruth::GroundTruth(const ReferenceShape& of) : reference(&of) {
  const Shape shape{.vertices = of.vertices, .triangles = of.triangles};
  diagonal = bounding_box_diagonal(shape);
  if (!is_cloud(shape)) normals.emplace(shape);
}

MeasuredShape measure_through_cache(const ShapeComparison& comparison, std::size_t index, std::span<const Field> fields,
                                    const GroundTruth* truth, const RunControl& control, Cache& cache) {
  const ComparedShape& source = comparison.shapes[index];
  const bool is_compared_with = comparison.reference == index && comparison.registered;
  const Stopwatch reading;
  const std::optional<ShapeSource> file =
      source.generated ? std::nullopt : std::optional(read_shape_source(source.file));
  const double file_seconds = reading.seconds();

  const std::string hash = source_hash(source, file);
  const std::string shape = shape_key({.sha256 = hash, .file = source.file, .id = source.name, .index = index},
                                      comparison.preparation, source.perturbations, comparison.seed);
  std::string compared_with = truth != nullptr ? truth->reference->key : "";
  if (is_compared_with) compared_with = "itself";  // its record has more contents than that of an equal shape
  const std::string key = key_of_measurement(comparison, shape, compared_with, thread_count(control));
  MeasuredShape measured = cache.get(EntryKind::comparison, key, [&] {
    const Stopwatch parsing;
    Shape read = file ? read_shape(*file) : generate_model(*source.generated);
    const double read_seconds = file_seconds + parsing.seconds();
    PerturbedShape perturbed =
        perturb_model(std::move(read), source.perturbations, comparison.seed, source.name, index);
    std::optional<ReferenceShape> as_reference;
    if (is_compared_with) {
      as_reference.emplace(ReferenceShape{
          .key = shape, .vertices = perturbed.shape.vertices, .triangles = perturbed.shape.triangles, .values = {}});
    }
    MeasuredShape computed =
        measure_shape(comparison, std::move(perturbed), fields, truth, std::move(as_reference), control);
    computed.read_seconds = read_seconds;
    return computed;
  });
  measured.name = source.name;
  return measured;
}

}  // namespace shapegauge
