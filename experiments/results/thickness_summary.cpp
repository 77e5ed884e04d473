// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/results/thickness_summary.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

using OrderedSummary = nlohmann::ordered_json;

/// Formats a number with five digits.
std::string short_number(double value) { return std::isnan(value) ? "none" : plain_number(value, 5); }

OrderedSummary number_or_null(double value) {
  return std::isnan(value) ? OrderedSummary(nullptr) : OrderedSummary(value);
}

double percent_below(const ThicknessSummary& summary) {
  return summary.area > 0 ? 100 * *summary.area_below / summary.area : std::numeric_limits<double>::quiet_NaN();
}

std::string name_of_percentile(int percent) { return percent == 50 ? "median" : fmt::format("{} %", percent); }

}  // namespace

ThicknessSummary summarise(const ScalarField& field, std::optional<double> threshold) {
  ThicknessSummary summary{.samples = static_cast<std::size_t>(field.values.size())};
  std::vector<std::pair<double, double>> known;  // value and weight
  double below = 0;
  for (Eigen::Index i = 0; i < field.values.size(); ++i) {
    const double value = field.values[i];
    if (std::isnan(value)) {
      ++summary.missing;
      continue;
    }
    if (!(field.weights[i] > 0)) continue;
    known.emplace_back(value, field.weights[i]);
    summary.area += field.weights[i];
    summary.mean += field.weights[i] * value;
    if (threshold && value < *threshold) below += field.weights[i];
  }
  if (threshold) summary.area_below = below;
  if (known.empty()) {
    summary.least = summary.greatest = summary.mean = std::numeric_limits<double>::quiet_NaN();
    summary.percentiles.fill(summary.mean);
    return summary;
  }
  summary.mean /= summary.area;
  std::ranges::sort(known);
  summary.least = known.front().first;
  summary.greatest = known.back().first;
  double area = 0;
  std::size_t next = 0;
  for (const auto& [value, weight] : known) {
    area += weight;
    while (next < summary_percentiles.size() && 100 * area >= summary_percentiles[next] * summary.area * (1 - 1e-12)) {
      summary.percentiles[next++] = value;
    }
  }
  while (next < summary_percentiles.size()) summary.percentiles[next++] = summary.greatest;
  return summary;
}

TextTable thickness_summary_table(std::span<const NamedSummary> summaries, const SummaryWords& words) {
  const std::string unit = words.unit.empty() ? "" : fmt::format(" ({})", words.unit);
  TextTable table{.header = {"shape", "samples", "missing",
                             words.unit.empty() ? "area" : fmt::format("area ({}²)", words.unit), "min" + unit}};
  for (const int percent : summary_percentiles) table.header.push_back(name_of_percentile(percent) + unit);
  for (const char* name : {"max", "mean"}) table.header.push_back(name + unit);
  if (words.threshold) table.header.push_back(fmt::format("area below {:g}{} (%)", *words.threshold, words.unit));
  for (const auto& [name, summary] : summaries) {
    std::vector<std::string> row{name, std::to_string(summary.samples), std::to_string(summary.missing),
                                 short_number(summary.area), short_number(summary.least)};
    for (const double value : summary.percentiles) row.push_back(short_number(value));
    row.push_back(short_number(summary.greatest));
    row.push_back(short_number(summary.mean));
    if (words.threshold) {
      const double percent = percent_below(summary);
      row.push_back(std::isnan(percent) ? "none" : decimal_text(percent, 2));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

nlohmann::ordered_json summary_json(const NamedSummary& named, const SummaryWords& words) {
  const ThicknessSummary& summary = named.summary;
  OrderedSummary json{
      {"file", named.name},         {"samples", summary.samples},
      {"missing", summary.missing}, {"unit", words.unit.empty() ? OrderedSummary(nullptr) : OrderedSummary(words.unit)},
      {"area", summary.area},       {"min", number_or_null(summary.least)}};
  OrderedSummary percentiles;
  for (std::size_t k = 0; k < summary_percentiles.size(); ++k) {
    percentiles[std::to_string(summary_percentiles[k])] = number_or_null(summary.percentiles[k]);
  }
  json["percentiles"] = std::move(percentiles);
  json["max"] = number_or_null(summary.greatest);
  json["mean"] = number_or_null(summary.mean);
  if (words.threshold) {
    json["below"] = {{"threshold", *words.threshold},
                     {"area", *summary.area_below},
                     {"percent", number_or_null(percent_below(summary))}};
  }
  return json;
}

}  // namespace shapegauge
