#include "shapegauge/experiments/shape_comparison/run_shape_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/experiments/signatures/signature_tables.h"

namespace shapegauge {

namespace {

/// Reference data of a comparison.
struct ReferenceShape {
  double diagonal = 0;
  std::optional<TrueNormals> normals;  ///< if it is a mesh
  std::vector<PlacedValues> values;    ///< by field
};

/// Shape of a comparison with the data for its histograms.
struct MeasuredShape {
  ShapeMeasurement measurement;
  ModelDescription description;
};

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

/// Reads, perturbs and prepares the shape of this index, and computes the planned fields on it. `reference` is the
/// shape to compare with, or null; measuring the reference itself fills it. Throws as describe_shape() does, and
/// Interrupted between fields.
MeasuredShape measure_shape(const ShapeComparison& comparison, std::size_t index, std::span<const PlannedField> plan,
                            ReferenceShape* reference, const RunControl& control) {
  const ComparedShape& source = comparison.shapes[index];
  const bool is_reference = comparison.reference == index;
  MeasuredShape measured;
  measured.measurement.name = source.name;

  const Stopwatch stopwatch;
  Shape shape = shape_of(source);
  measured.measurement.read_seconds = stopwatch.seconds();
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
    const PlacedValues placed =
        placed_values(samples, computed.values, plan[field].field.dimension, std::sqrt(prepared.area));
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

/// Returns the shapes' indices with the reference first, to which the others are compared.
std::vector<std::size_t> measuring_order(const ShapeComparison& comparison) {
  std::vector<std::size_t> order(comparison.shapes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (comparison.reference) {
    const auto reference = order.begin() + static_cast<std::ptrdiff_t>(*comparison.reference);
    std::rotate(order.begin(), reference, reference + 1);
  }
  return order;
}

/// Returns why a shape failed; throws if the comparison cannot continue without it.
std::string failure_of(const ShapeComparison& comparison, std::size_t index, const std::exception& error) {
  const std::string what = fmt::format("shape \"{}\": {}", comparison.shapes[index].name, error.what());
  if (comparison.reference == index) throw InputError(what + "; it is the reference: repair it or choose another");
  if (comparison.on_error == OnError::skip) return error.what();
  throw InputError(what + R"(; repair or remove it, or set "on_error" to "skip")");
}

/// Results or failures by shape.
struct Measured {
  std::vector<std::optional<MeasuredShape>> shapes;
  std::vector<std::string> failures;  ///< by shape; empty for successful ones
};

/// Checks the file of every shape before anything is computed.
void check_files(const ShapeComparison& comparison, Measured& measured) {
  for (std::size_t i = 0; i < comparison.shapes.size(); ++i) {
    if (comparison.shapes[i].generated) continue;
    try {
      check_shape_header(comparison.shapes[i].file);
    } catch (const InputError& error) {
      measured.failures[i] = failure_of(comparison, i, error);
    }
  }
}

Measured measure_shapes(const ShapeComparison& comparison, std::span<const PlannedField> plan,
                        const RunControl& control) {
  Measured measured;
  measured.shapes.resize(comparison.shapes.size());
  measured.failures.resize(comparison.shapes.size());
  check_files(comparison, measured);
  ReferenceShape reference;
  ReferenceShape* compared_with = comparison.reference && comparison.registered ? &reference : nullptr;
  std::size_t done = 0;
  for (const std::size_t i : measuring_order(comparison)) {
    if (control.interrupted()) throw Interrupted();
    control.progress("shapes", done++, comparison.shapes.size());
    if (!measured.failures[i].empty()) continue;
    try {
      measured.shapes[i] = measure_shape(comparison, i, plan, compared_with, control);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      measured.failures[i] = failure_of(comparison, i, error);
    }
  }
  return measured;
}

/// Computes the distances of all shapes from the reference at a row.
std::vector<double> distances_from(std::size_t row, const Signatures& histograms, const std::string& distance) {
  const DistanceMatrix matrix = distance_matrix(histograms, distance);
  const auto distances = matrix.col(static_cast<Eigen::Index>(row));
  return {distances.begin(), distances.end()};
}

std::vector<SignatureResults> signature_results(const ShapeComparison& comparison, std::span<const PlannedField> plan,
                                                const std::vector<const ModelDescription*>& models,
                                                std::optional<std::size_t> reference_row) {
  std::vector<Signatures> tables =
      assemble_signatures(models, plan, comparison.signatures, field_ranges(models, plan.size()));
  std::vector<SignatureResults> results(tables.size());
  for (std::size_t field = 0; field < plan.size(); ++field) {
    for (const std::size_t i : plan[field].signatures) {
      results[i].field = field;
      results[i].ranges = histogram_ranges(models, comparison.signatures[i].histogram, field);
      if (reference_row) results[i].distances = distances_from(*reference_row, tables[i], comparison.distance);
      results[i].histograms = std::move(tables[i]);
    }
  }
  return results;
}

void run_stages(const RunControl& control, ShapeComparisonResults& results) {
  const ShapeComparison& comparison = results.comparison;
  const std::vector<PlannedField> plan = plan_fields(comparison.signatures);
  const Stopwatch stopwatch;
  Measured measured = measure_shapes(comparison, plan, control);
  results.timings.emplace_back("shapes", stopwatch.seconds());

  const Stopwatch second_stage;
  std::vector<const ModelDescription*> models;
  std::optional<std::size_t> reference_row;
  for (std::size_t i = 0; i < measured.shapes.size(); ++i) {
    if (!measured.shapes[i]) {
      results.failures.push_back({.id = comparison.shapes[i].name, .message = measured.failures[i]});
      continue;
    }
    if (comparison.reference == i) reference_row = models.size();
    models.push_back(&measured.shapes[i]->description);
    results.shapes.push_back(std::move(measured.shapes[i]->measurement));
    results.shapes.back().report = report_shape(*models.back());
  }
  if (models.empty()) {
    throw InputError(fmt::format("none of the {} shapes can be used; the first: {}", results.failures.size(),
                                 results.failures.front().message));
  }
  results.fields = report_fields(models, plan);
  results.signatures = signature_results(comparison, plan, models, reference_row);
  results.timings.emplace_back("histograms", second_stage.seconds());
}

}  // namespace

ShapeComparisonResults run_shape_comparison(const ShapeComparison& comparison, const RunControl& control) {
  ShapeComparisonResults results;
  results.comparison = comparison;
  results.threads = control.threads > 0 ? control.threads : available_threads();
  with_threads(control, [&] { run_stages(control, results); });
  return results;
}

}  // namespace shapegauge
