#include "shapegauge/experiments/comparison/comparison_tables.h"

#include <fmt/format.h>
#include <functional>
#include <string>
#include <vector>

namespace shapegauge {

namespace {

using Row = std::vector<std::string>;

std::string number(double value) { return fmt::format("{:.6g}", value); }

/// Calls with the signature's index and name, and with each shape's index.
void for_each_row(const ComparisonResults& results,
                  const std::function<void(std::size_t signature, std::size_t shape, Row names)>& add) {
  for (std::size_t i = 0; i < results.signatures.size(); ++i) {
    for (std::size_t j = 0; j < results.shapes.size(); ++j) {
      add(i, j, {results.comparison.signatures[i].name, results.shapes[j].name});
    }
  }
}

const FieldMeasurement& measurement_of(const ComparisonResults& results, std::size_t signature, std::size_t shape) {
  return results.shapes[shape].fields[results.signatures[signature].field];
}

void append(Row& row, const NormalErrors& errors) {
  for (const double value : {errors.mean, errors.median, errors.percentile_90}) row.push_back(number(value));
}

}  // namespace

Table histograms_table(const ComparisonResults& results) {
  Table table{.header = {"signature", "shape", "bin", "low", "high", "share"}, .rows = {}, .text_columns = 2};
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

Table distances_table(const ComparisonResults& results) {
  const Comparison& comparison = results.comparison;
  Table table{.header = {"signature", "shape", "reference", comparison.distance}, .rows = {}, .text_columns = 3};
  if (!comparison.reference) return table;
  for_each_row(results, [&](std::size_t i, std::size_t j, Row row) {
    row.push_back(comparison.shapes[*comparison.reference].name);
    row.push_back(number(results.signatures[i].distances[j]));
    table.rows.push_back(std::move(row));
  });
  return table;
}

Table errors_table(const ComparisonResults& results) {
  Table table{.header = {"signature", "shape", "samples", "missing", "median_of_diagonal", "percentile_90_of_diagonal",
                         "median_relative", "percentile_90_relative"},
              .rows = {},
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

Table normals_table(const ComparisonResults& results) {
  Table table{
      .header = {"signature", "shape", "samples", "offset_mean_degrees", "offset_median_degrees",
                 "offset_percentile_90_degrees", "own_mean_degrees", "own_median_degrees", "own_percentile_90_degrees"},
      .rows = {},
      .text_columns = 2};
  for_each_row(results, [&](std::size_t i, std::size_t j, Row row) {
    const FieldMeasurement& measured = measurement_of(results, i, j);
    if (!measured.offset_normals || !measured.own_normals) return;
    row.push_back(std::to_string(measured.samples));
    append(row, *measured.offset_normals);
    append(row, *measured.own_normals);
    table.rows.push_back(std::move(row));
  });
  return table;
}

Table timings_table(const ComparisonResults& results) {
  Table table{.header = {"signature", "shape", "samples", "read_seconds", "build_seconds", "query_seconds",
                         "microseconds_per_sample"},
              .rows = {},
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

}  // namespace shapegauge
