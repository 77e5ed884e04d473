// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/shape_comparison/write_shape_comparison.h"

#include <fmt/format.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/signatures/shape_reports.h"

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;
using Row = std::vector<std::string>;

std::string number(double value) { return fmt::format("{:.6g}", value); }

/// Calls a function for each signature (index and name) and each shape (index).
void for_each_row(const ShapeComparisonResults& results,
                  const std::function<void(std::size_t signature, std::size_t shape, Row names)>& add) {
  for (std::size_t i = 0; i < results.signatures.size(); ++i) {
    for (std::size_t j = 0; j < results.shapes.size(); ++j) {
      add(i, j, {results.comparison.signatures[i].name, results.shapes[j].name});
    }
  }
}

const FieldMeasurement& measurement_of(const ShapeComparisonResults& results, std::size_t signature,
                                       std::size_t shape) {
  return results.shapes[shape].fields[results.signatures[signature].field];
}

void append(Row& row, const NormalErrors& errors) {
  for (const double value : {errors.mean, errors.median, errors.percentile_90}) row.push_back(number(value));
}

/// Makes a table with a row for each signature, shape and bin: the bin's number and bounds, and its fraction of the
/// area.
TextTable histograms_table(const ShapeComparisonResults& results) {
  TextTable table{.header = {"signature", "shape", "bin", "low", "high", "share"}, .rows = {}, .text_columns = 2};
  for_each_row(results, [&](std::size_t i, std::size_t j, const Row& names) {
    const Interval& range = results.signatures[i].ranges[j];
    const auto histogram = results.signatures[i].histograms.row(static_cast<Eigen::Index>(j));
    const double width = (range.high - range.low) / static_cast<double>(histogram.size());
    for (Eigen::Index bin = 0; bin < histogram.size(); ++bin) {
      const double low = range.low + static_cast<double>(bin) * width;
      table.rows.push_back({names[0], names[1], std::to_string(bin), number(low), number(low + width),
                            number(static_cast<double>(histogram[bin]))});
    }
  });
  return table;
}

/// Makes a table with a row for each signature and shape: its distance from the reference. No rows without a reference.
TextTable distances_table(const ShapeComparisonResults& results) {
  const ShapeComparison& comparison = results.comparison;
  TextTable table{.header = {"signature", "shape", "reference", comparison.distance}, .rows = {}, .text_columns = 3};
  if (!comparison.reference) return table;
  for_each_row(results, [&](std::size_t i, std::size_t j, Row row) {
    row.push_back(comparison.shapes[*comparison.reference].name);
    row.push_back(number(results.signatures[i].distances[j]));
    table.rows.push_back(std::move(row));
  });
  return table;
}

/// Makes a table with a row for each signature and shape: numbers of samples and of missing values, and ValueErrors if
/// any.
TextTable errors_table(const ShapeComparisonResults& results) {
  TextTable table{.header = {"signature", "shape", "samples", "missing", "median_of_diagonal",
                             "percentile_90_of_diagonal", "median_relative", "percentile_90_relative"},
                  .text_columns = 2};
  for_each_row(results, [&](std::size_t i, std::size_t j, Row row) {
    const FieldMeasurement& measured = measurement_of(results, i, j);
    if (!measured.errors) return;
    row.push_back(std::to_string(measured.samples));
    row.push_back(std::to_string(measured.missing));
    const ValueErrors& errors = *measured.errors;
    for (const double value :
         {errors.median, errors.percentile_90, errors.relative_median, errors.relative_percentile_90}) {
      row.push_back(number(value));
    }
    table.rows.push_back(std::move(row));
  });
  return table;
}

/// Makes a table with a row for each shape and signature whose field estimates normals: NormalErrors of those and of
/// the shape's normals.
TextTable normals_table(const ShapeComparisonResults& results) {
  TextTable table{
      .header = {"signature", "shape", "samples", "offset_mean_degrees", "offset_median_degrees",
                 "offset_percentile_90_degrees", "own_mean_degrees", "own_median_degrees", "own_percentile_90_degrees"},
      .text_columns = 2};
  for_each_row(results, [&](std::size_t i, std::size_t j, Row row) {
    const FieldMeasurement& measured = measurement_of(results, i, j);
    if (!measured.offset_normals || !measured.shape_normals) return;
    row.push_back(std::to_string(measured.samples));
    append(row, *measured.offset_normals);
    append(row, *measured.shape_normals);
    table.rows.push_back(std::move(row));
  });
  return table;
}

/// Makes a table with a row for each signature and shape: run times. Only this table varies between runs.
TextTable timings_table(const ShapeComparisonResults& results) {
  TextTable table{.header = {"signature", "shape", "samples", "read_seconds", "build_seconds", "query_seconds",
                             "microseconds_per_sample"},
                  .text_columns = 2};
  for_each_row(results, [&](std::size_t i, std::size_t j, Row row) {
    const FieldMeasurement& measured = measurement_of(results, i, j);
    const double seconds = measured.build_seconds + measured.query_seconds;
    row.push_back(std::to_string(measured.samples));
    for (const double value : {results.shapes[j].read_seconds, measured.build_seconds, measured.query_seconds}) {
      row.push_back(fmt::format("{:.6f}", value));
    }
    row.push_back(fmt::format("{:.3f}", 1e6 * seconds / static_cast<double>(measured.samples)));
    table.rows.push_back(std::move(row));
  });
  return table;
}

TextTable shapes_table(const ShapeComparisonResults& results) {
  TextTable table{.header = {"shape"}, .rows = {}};
  std::vector<ModelDescription> descriptions;
  for (const MeasuredShape& shape : results.shapes) {
    table.rows.push_back({shape.name});
    descriptions.push_back(shape.description);
  }
  return with_shape_reports(std::move(table), descriptions, results.comparison.preparation, results.fields);
}

/// Returns a note on shapes that could not be perturbed as requested.
std::vector<std::string> notes_of(const ShapeComparisonResults& results) {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> remarks;
  for (const MeasuredShape& shape : results.shapes) {
    names.push_back(shape.name);
    remarks.push_back(shape.description.remarks);
  }
  const std::string note = note_on_shapes(names, remarks, "shape", not_perturbed);
  return note.empty() ? std::vector<std::string>() : std::vector{note};
}

/// Returns the tables of comparison results by title, without empty ones.
std::vector<std::pair<std::string, TextTable>> comparing_tables(const ShapeComparisonResults& results) {
  std::vector<std::pair<std::string, TextTable>> tables{
      {"Distances", distances_table(results)}, {"Errors", errors_table(results)}, {"Normals", normals_table(results)}};
  std::erase_if(tables, [](const auto& titled) { return titled.second.rows.empty(); });
  return tables;
}

std::string summary_markdown(const ShapeComparisonResults& results) {
  std::string text = fmt::format("# {}\n", markdown_text(results.comparison.name));
  if (!results.comparison.description.empty()) text += fmt::format("\n{}\n", results.comparison.description);
  for (const auto& [title, table] : comparing_tables(results)) {
    text += fmt::format("\n## {}\n\n{}", title, to_markdown(table));
  }
  const std::vector<std::string> warnings = field_warnings(results.fields);
  if (!warnings.empty()) text += "\n## Warnings\n\n";
  for (const std::string& warning : warnings) text += fmt::format("- {}\n", markdown_text(warning));
  return text;
}

std::vector<std::pair<std::string, std::string>> comparison_files(const ShapeComparisonResults& results) {
  std::vector<std::pair<std::string, std::string>> files{{"summary.md", summary_markdown(results)},
                                                         {"histograms.csv", to_csv(histograms_table(results))},
                                                         {"timings.csv", to_csv(timings_table(results))},
                                                         {"shapes.csv", to_csv(shapes_table(results))}};
  if (!results.comparison.reference) return files;
  files.emplace_back("distances.csv", to_csv(distances_table(results)));
  if (!results.comparison.registered) return files;
  files.emplace_back("errors.csv", to_csv(errors_table(results)));
  files.emplace_back("normals.csv", to_csv(normals_table(results)));
  return files;
}

/// Returns the hashes of the shapes' files that can be read.
OrderedJson inputs_of(const ShapeComparison& comparison) {
  OrderedJson shapes = OrderedJson::object();
  for (const ComparedShape& shape : comparison.shapes) {
    if (shape.generated) continue;
    const std::string hash = sha256_if_readable(shape.file);
    if (!hash.empty()) shapes[shape.name] = hash;
  }
  return {{"algorithm", "SHA-256"}, {"shapes", std::move(shapes)}};
}

OrderedJson manifest_entries(const ShapeComparisonResults& results) {
  return {{"seed", results.comparison.seed},
          {"inputs", inputs_of(results.comparison)},
          {"shapes", results.shapes.size()},
          {"failed_models", failures_json(results.failures)},
          {"fields", fields_json(results.fields)}};
}

/// Formats the summary for a terminal: distances, errors, normals, timings.
std::string summary_text(const ShapeComparisonResults& results) {
  std::string text;
  for (const auto& [title, table] : comparing_tables(results)) {
    text += fmt::format("{}\n{}\n", title, to_plain_text(table));
  }
  return text + fmt::format("Timings ({} threads)\n{}", results.threads, to_plain_text(timings_table(results)));
}

}  // namespace

RunOutcome write_shape_comparison(const RunResults& to, const ShapeComparisonResults& results) {
  to.manifest = manifest_entries(results);
  to.execution = execution_json(results.threads, results.timings, results.fields, results.cache);
  RunOutcome outcome{.summary = summary_text(results),
                     .notes = notes_of(results),
                     .warnings = field_warnings(results.fields),
                     .left_out = results.failures,
                     .used = results.shapes.size(),
                     .noun = "shape",
                     .cache = results.cache};
  for (const auto& [name, text] : comparison_files(results)) {
    write_file_atomically(to.folder / name, text);
    outcome.files.push_back(name);
  }
  return outcome;
}

namespace {

Experiment read_comparison(const nlohmann::json& document, const std::string& source,
                           const std::filesystem::path& folder) {
  const ShapeComparison comparison = comparison_from_json(document, source, folder);
  std::vector<std::filesystem::path> files;
  for (const ComparedShape& shape : comparison.shapes) files.push_back(shape.file);
  return {.name = comparison.name,
          .configuration = [comparison] { return to_json(comparison); },
          .input_paths = std::move(files),
          .inputs = [comparison](int) { return inputs_of(comparison); },
          .run =
              [comparison](const RunContext& context, const RunResults& to) {
                return write_shape_comparison(to, run_shape_comparison(comparison, context));
              },
          .run_part = [comparison](const RunContext& context,
                                   const Part& part) { return run_part_of_comparison(comparison, context, part); }};
}

}  // namespace

ExperimentKind comparison_kind() {
  return {.name = "comparison",
          .description = "A few shapes, compared with one of them: values, normals, histograms, times.",
          .keys = {"shapes"},
          .paths = {.files = {"/shapes/*/file"}},
          .schema =
              [] {
                return OrderedJson{{"$ref", "#/definitions/comparison_experiment"}};
              },
          .read = read_comparison};
}

}  // namespace shapegauge
