// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/shape_comparison/run_shape_comparison.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/experiments/signatures/signature_tables.h"

namespace shapegauge {

namespace {

/// Checks the file of every shape before anything is computed.
std::vector<ModelFailure> check_files(const ShapeComparison& comparison) {
  std::vector<ModelFailure> failures;
  for (std::size_t i = 0; i < comparison.shapes.size(); ++i) {
    if (comparison.shapes[i].generated) continue;
    try {
      check_shape_header(comparison.shapes[i].file);
    } catch (const InputError& error) {
      failures.push_back({.model = i, .message = error.what()});
    }
  }
  return failures;
}

/// Throws if the comparison cannot continue after the failures.
void check_failures(const ShapeComparison& comparison, const std::vector<ModelFailure>& failures) {
  for (const ModelFailure& failure : failures) {
    const bool is_reference = comparison.reference == failure.model;
    if (!is_reference && comparison.on_error == OnError::skip) continue;
    throw InputError(fmt::format("shape \"{}\": {}; {}", comparison.shapes[failure.model].name, failure.message,
                                 is_reference ? "it is the reference: repair it or choose another"
                                              : R"(repair or remove it, or set "on_error" to "skip")"));
  }
  if (failures.size() < comparison.shapes.size()) return;
  throw InputError(
      fmt::format("none of the {} shapes can be used; the first: {}", failures.size(), failures.front().message));
}

/// Measurement of the shapes of a comparison.
class Measuring {
 public:
  Measuring(const ShapeComparison& comparison, std::span<const Field> fields, const RunContext& context)
      : comparison_(&comparison), fields_(fields), context_(&context) {}

  /// Measures the shapes of the part and, first, the reference if shapes are compared with it. Throws as
  /// run_shape_comparison() does.
  void run(const Part& part) {
    add_failures(check_files(*comparison_));
    std::vector<std::size_t> usable;
    for (std::size_t i = 0; i < comparison_->shapes.size(); ++i) {
      if (std::ranges::find(failures, i, &ModelFailure::model) == failures.end()) usable.push_back(i);
    }
    std::vector<std::size_t> shard = part.of(usable);
    std::optional<GroundTruth> truth;
    if (comparison_->reference && comparison_->registered) {
      measure({*comparison_->reference}, "reference", nullptr);
      std::erase(shard, *comparison_->reference);
      truth.emplace(shapes.at(*comparison_->reference).reference.value());
    }
    measure(shard, "shapes", truth ? &*truth : nullptr);
  }

  std::map<std::size_t, MeasuredShape> shapes;  ///< by index
  std::vector<ModelFailure> failures;           ///< in order

 private:
  void add_failures(const std::vector<ModelFailure>& more) {
    failures.insert(failures.end(), more.begin(), more.end());
    std::ranges::sort(failures, {}, &ModelFailure::model);
    check_failures(*comparison_, failures);
  }

  void measure(const std::vector<std::size_t>& indices, std::string_view stage, const GroundTruth* truth) {
    const bool stop = comparison_->on_error == OnError::stop;
    add_failures(for_each_model_in_turn(indices, stage, stop, context_->control, [&](std::size_t i) {
      shapes.emplace(i, measure_through_cache(*comparison_, i, fields_, truth, context_->control, context_->cache));
    }));
  }

  const ShapeComparison* comparison_;
  std::span<const Field> fields_;
  const RunContext* context_;
};

/// Computes the distances of all shapes from the reference at a row.
std::vector<double> distances_from(std::size_t row, const Signatures& histograms, const std::string& distance) {
  const DistanceMatrix matrix = distance_matrix(histograms, distance);
  const auto distances = matrix.col(static_cast<Eigen::Index>(row));
  return {distances.begin(), distances.end()};
}

std::vector<SignatureResults> signature_results(const ShapeComparison& comparison, std::span<const Field> fields,
                                                const std::vector<const ModelDescription*>& models,
                                                std::optional<std::size_t> reference_row) {
  std::vector<Signatures> tables =
      assemble_signatures(models, fields, comparison.signatures, field_ranges(models, fields.size()));
  std::vector<SignatureResults> results(tables.size());
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const SignatureConfiguration& signature = comparison.signatures[i];
    results[i].field = index_of(fields, signature.field.value());
    results[i].ranges = histogram_ranges(models, signature.histogram, results[i].field);
    if (reference_row) results[i].distances = distances_from(*reference_row, tables[i], comparison.distance);
    results[i].histograms = std::move(tables[i]);
  }
  return results;
}

void run_stages(const RunContext& context, ShapeComparisonResults& results) {
  const ShapeComparison& comparison = results.comparison;
  const std::vector<Field> fields = distinct_fields(comparison.signatures);
  const Stopwatch stopwatch;
  Measuring measured(comparison, fields, context);
  measured.run({});
  results.timings.emplace_back("shapes", stopwatch.seconds());

  const Stopwatch second_stage;
  for (const ModelFailure& failure : measured.failures) {
    results.failures.push_back({.id = comparison.shapes[failure.model].name, .message = failure.message});
  }
  std::vector<const ModelDescription*> models;
  std::optional<std::size_t> reference_row;
  for (const auto& [index, shape] : measured.shapes) {
    if (comparison.reference == index) reference_row = models.size();
    models.push_back(&shape.description);
  }
  results.fields = report_fields(models, fields);
  results.signatures = signature_results(comparison, fields, models, reference_row);
  for (auto& [index, shape] : measured.shapes) {
    shape.description = without_values(std::move(shape.description));
    shape.reference.reset();
    results.shapes.push_back(std::move(shape));
  }
  results.timings.emplace_back("histograms", second_stage.seconds());
}

}  // namespace

ShapeComparisonResults run_shape_comparison(const ShapeComparison& comparison, const RunContext& context) {
  ShapeComparisonResults results;
  results.comparison = comparison;
  results.threads = thread_count(context.control);
  with_threads(context.control, [&] { run_stages(context, results); });
  results.cache = context.cache.report();
  return results;
}

PartOutcome run_part_of_comparison(const ShapeComparison& comparison, const RunContext& context, const Part& part) {
  const std::vector<Field> fields = distinct_fields(comparison.signatures);
  PartOutcome outcome{.all = comparison.shapes.size(), .noun = "shape"};
  with_threads(context.control, [&] {
    Measuring measured(comparison, fields, context);
    measured.run(part);
    outcome.shapes = measured.shapes.size();
    for (const ModelFailure& failure : measured.failures) {
      outcome.left_out.push_back({.id = comparison.shapes[failure.model].name, .message = failure.message});
    }
  });
  return outcome;
}

}  // namespace shapegauge
