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

/// Percentiles of a summary.
inline constexpr std::array<int, 7> summary_percentiles{1, 5, 25, 50, 75, 95, 99};

/// Area-weighted statistics of the thickness of a shape.
struct ThicknessSummary {
  std::size_t samples = 0;
  std::size_t missing = 0;  ///< samples without a value, which are ignored below
  double area = 0;          ///< of the samples with a value, in squared units of the shape
  double least = 0;
  double greatest = 0;
  double mean = 0;
  /// Weighted percentiles: the smallest values whose cumulative area reaches that fraction.
  std::array<double, summary_percentiles.size()> percentiles{};
  std::optional<double> area_below = {};  ///< area of samples below the threshold, if one is given
};

/// Computes the summary of a field; NaN values and zero areas if no sample has a value.
ThicknessSummary summarise(const ScalarField& field, std::optional<double> threshold = {});

/// Summary with the name of its shape.
struct NamedSummary {
  std::string name;
  ThicknessSummary summary;
};

/// Formatting of summaries.
struct SummaryWords {
  std::string unit = {};                 ///< of lengths; empty if unknown
  std::optional<double> threshold = {};  ///< in that unit, as given to summarise()
};

/// Makes a table with a row for each shape. Areas below the threshold are in percent of the area.
TextTable thickness_summary_table(std::span<const NamedSummary> summaries, const SummaryWords& words);

/// Formats the summary with all digits: samples, missing, unit, area, min, percentiles, max, mean, below. Unknown
/// values are null.
nlohmann::ordered_json summary_json(const NamedSummary& summary, const SummaryWords& words);

}  // namespace shapegauge
