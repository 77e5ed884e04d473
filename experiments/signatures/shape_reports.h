// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/signatures/describe_model.h"

/// Reports on models and fields, and their tables.

namespace shapegauge {

/// Returns true if the model's gaps are wider than an offset, a fraction of the diagonal: the offset surface then leaks
/// into the model. False without an offset.
bool offset_leaks(const ShapeDiagnostics& model, std::optional<double> offset);

/// Report on a field over all models used.
struct FieldReport {
  FieldSettings settings;
  FieldOutcomes outcomes = {};  ///< totals
  double seconds = 0;           ///< total over the models, including concurrent work
  std::size_t models = 0;       ///< with values of it
  std::size_t leaking = 0;      ///< models with gaps wider than the field's offset (gap_sizes()), into which it leaks
};

/// Returns the reports on the fields over all models.
std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const Field> fields);

/// Returns a note on the shapes that have remarks, such as "3 of 9 shapes leak; the first, 1: gap of 2 %"; empty if
/// there are none. `remarks` are those of each shape, `noun` is that for a shape, `verb` says what the shapes with
/// remarks do.
std::string note_on_shapes(std::span<const std::string> names, std::span<const std::vector<std::string>> remarks,
                           std::string_view noun, std::string_view verb);

/// `verb` of note_on_shapes() for shapes whose perturbations fell short of their settings.
inline constexpr std::string_view not_perturbed = "were not perturbed as requested";

/// Returns warnings about the fields, one sentence each: offsets that leak, samples undecided or without a value.
std::vector<std::string> field_warnings(std::span<const FieldReport> fields);

/// Formats diagnostics by the names of ShapeDiagnostics. `boundary_fraction`, `gap_fraction` and `noise_fraction` are
/// lengths divided by the diagonal, or 0 without one.
nlohmann::ordered_json diagnostics_json(const ShapeDiagnostics& diagnostics);

/// Adds columns to a table whose rows are shapes: the choices of perturbations, the diagnostics, and for each field the
/// number of samples by outcome.
TextTable with_shape_reports(TextTable table, std::span<const ModelDescription> shapes,
                             const PreparationOptions& preparation, std::span<const FieldReport> fields);

/// Makes a table with a row for each model: id, class, choices of perturbations, diagnostics, and for each field the
/// number of samples by outcome. The same for any number of threads.
TextTable shapes_table(std::span<const Model> models, std::span<const std::string> classes,
                       std::span<const ModelDescription> shapes, const PreparationOptions& preparation,
                       std::span<const FieldReport> fields);

/// Makes a table with a row for each model: id, and the seconds of each field and each descriptor.
TextTable shape_seconds_table(std::span<const Model> models, std::span<const ModelDescription> shapes,
                              std::span<const FieldReport> fields, std::span<const SignatureConfiguration> signatures);

/// Formats for each field its settings, its samples by outcome, and the number of shapes that its offset leaks into.
nlohmann::ordered_json fields_json(std::span<const FieldReport> fields);

/// Formats the manifest's "execution": threads, seconds by stage and by field, and numbers of results from the cache by
/// kind.
nlohmann::ordered_json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                                      std::span<const FieldReport> fields, const CacheReport& cache);

}  // namespace shapegauge
