// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

/// Percentiles of the thickness in a summary, in percent of the area.
inline constexpr std::array<int, 7> summary_percentiles{1, 5, 25, 50, 75, 95, 99};

/// Area-weighted statistics of the thickness of a shape.
struct ThicknessSummary {
  std::size_t samples = 0;  ///< number of samples of the shape, with and without a value
  std::size_t missing = 0;  ///< number of samples without a value; the statistics ignore them
  double area = 0;          ///< total area of the samples with a value, in squared units of the shape
  double least = 0;         ///< smallest thickness
  double greatest = 0;      ///< largest thickness
  double mean = 0;          ///< area-weighted mean of the thickness
  /// Weighted percentiles (summary_percentiles): the smallest values whose cumulative area reaches the percentage.
  std::array<double, summary_percentiles.size()> percentiles{};
  std::optional<double> area_below = {};  ///< area of samples below the threshold; absent without a threshold
};

/// Computes the summary of a thickness field. Values are NaN and areas 0 if no sample has a value. Without a threshold,
/// `area_below` is absent.
ThicknessSummary summarise(const ScalarField& field, std::optional<double> threshold = {});

/// Thickness summary with the name of its shape.
struct NamedSummary {
  std::string name;          ///< name of the shape, such as its file
  ThicknessSummary summary;  ///< statistics of the thickness
};

/// Unit and threshold for tables of thickness summaries.
struct SummaryWords {
  std::string unit = {};                 ///< unit of lengths, such as "mm"; empty if unknown
  std::optional<double> threshold = {};  ///< threshold of the thickness in `unit`, see summarise(); absent for none
};

/// Makes a table of thickness summaries with a row for each shape. Areas below the threshold are in percent of the
/// area.
TextTable thickness_summary_table(std::span<const NamedSummary> summaries, const SummaryWords& words);

/// Formats a thickness summary with all digits: samples, missing, unit, area, min, percentiles, max, mean, below.
/// Unknown values are null.
nlohmann::ordered_json summary_json(const NamedSummary& summary, const SummaryWords& words);

}  // namespace shapegauge
