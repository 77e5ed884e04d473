#include "shapegauge/experiments/comparison/measure_shape.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "shapegauge/core/io/read_shape.h"

namespace shapegauge {

namespace {

Shape shape_of(const ComparedShape& source) {
  return source.generated ? generate_model(*source.generated) : read_shape(source.file);
}

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

}  // namespace

MeasuredShape measure_shape(const Comparison& comparison, std::size_t index, std::span<const PlannedField> plan,
                            ReferenceShape* reference, const RunControl& control) {
  const ComparedShape& source = comparison.shapes[index];
  const bool is_reference = comparison.reference == index;
  MeasuredShape measured;
  measured.measurement.name = source.name;

  const auto start = std::chrono::steady_clock::now();
  Shape shape = shape_of(source);
  measured.measurement.read_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  PerturbedShape perturbed = perturb_model(std::move(shape), source.perturbations, comparison.seed, source.name, index);
  if (reference != nullptr && is_reference) {
    reference->diagonal = bounding_box_diagonal(perturbed.shape);
    if (!is_cloud(perturbed.shape)) reference->normals.emplace(perturbed.shape);
  }
  const auto observe = [&](std::size_t field, const PreparedShape& prepared, const Samples& samples,
                           const FieldValues& computed) {
    if (control.interrupted()) throw Interrupted();
    FieldMeasurement& measurement = measured.measurement.fields.emplace_back(measure_field(samples, computed));
    if (reference == nullptr) return;
    const PlacedValues placed = placed_values(samples, computed.values, std::sqrt(prepared.area));
    if (is_reference) reference->values.push_back(placed);
    measurement.errors = value_errors(placed, reference->values[field], reference->diagonal);
    if (reference->normals && computed.normals.rows() > 0) {
      compare_normals(*reference->normals, prepared, samples, computed.normals, measurement);
    }
  };
  measured.description =
      describe_shape(std::move(perturbed), comparison.preparation, comparison.signatures, plan, true, observe);
  return measured;
}

}  // namespace shapegauge
