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

/// Reports on the models and fields of a run, and tables of them.

namespace shapegauge {

/// Returns true if the widest gap of the model (gap_sizes()) exceeds the offset, a fraction of the bounding-box
/// diagonal: the offset surface then leaks into the model. False without an offset.
bool offset_leaks(const ShapeDiagnostics& model, std::optional<double> offset);

/// Sample counts, run time and leaks of one field over all models of a run.
struct FieldReport {
  FieldSettings settings;       ///< settings of the field
  FieldOutcomes outcomes = {};  ///< numbers of samples by outcome of the field, over all models
  double seconds = 0;           ///< sum of the run times on the models, in seconds; models may run concurrently
  std::size_t models = 0;       ///< number of models that have values of the field
  std::size_t leaking = 0;      ///< number of models that the offset surface leaks into (offset_leaks())
};

/// Returns the FieldReport of each field over all models.
std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const Field> fields);

/// Returns a note on the shapes that have remarks, such as "3 of 9 shapes leak; the first, 1: gap of 2 %"; empty if
/// there are none. `names` and `remarks` have one entry per shape. `noun` is the word for a shape ("shape"), `verb`
/// says what shapes with remarks do ("leak").
std::string note_on_shapes(std::span<const std::string> names, std::span<const std::vector<std::string>> remarks,
                           std::string_view noun, std::string_view verb);

/// Argument `verb` of note_on_shapes() for shapes whose perturbations achieved less than their settings request.
inline constexpr std::string_view not_perturbed = "were not perturbed as requested";

/// Returns warnings about the fields, one sentence each: offsets that leak, samples undecided or without a value.
std::vector<std::string> field_warnings(std::span<const FieldReport> fields);

/// Formats diagnostics as a JSON object with the names of ShapeDiagnostics as keys. `boundary_fraction`, `gap_fraction`
/// and `noise_fraction` are lengths divided by the bounding-box diagonal; 0 if the length is 0.
nlohmann::ordered_json diagnostics_json(const ShapeDiagnostics& diagnostics);

/// Adds columns to a table whose rows are shapes: the choices of perturbations, the diagnostics, results of the
/// preparation, and for each field the number of samples by outcome.
TextTable with_shape_reports(TextTable table, std::span<const ModelDescription> shapes,
                             const PreparationOptions& preparation, std::span<const FieldReport> fields);

/// Makes a table with one row per model: id, class, choices of perturbations, diagnostics, and for each field the
/// number of samples by outcome. The table is the same for any number of threads.
TextTable shapes_table(std::span<const Model> models, std::span<const std::string> classes,
                       std::span<const ModelDescription> shapes, const PreparationOptions& preparation,
                       std::span<const FieldReport> fields);

/// Makes a table with one row per model: id, and the run time of each field and each descriptor in seconds.
TextTable shape_seconds_table(std::span<const Model> models, std::span<const ModelDescription> shapes,
                              std::span<const FieldReport> fields, std::span<const SignatureConfiguration> signatures);

/// Formats, for each field, its settings, the number of samples by outcome, and the number of shapes with gaps wider
/// than the offset, as JSON.
nlohmann::ordered_json fields_json(std::span<const FieldReport> fields);

/// Formats the entry "execution" of a manifest: number of threads, seconds by stage and by field, and use of the cache
/// by kind of result (cache_json()).
nlohmann::ordered_json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                                      std::span<const FieldReport> fields, const CacheReport& cache);

}  // namespace shapegauge
