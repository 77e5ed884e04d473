#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

/// The percentiles of a summary.
inline constexpr std::array<int, 7> summary_percentiles{1, 5, 25, 50, 75, 95, 99};

/// The thickness of a shape in a few numbers, weighted by area.
struct ThicknessSummary {
  std::size_t samples = 0;
  std::size_t missing = 0;  ///< samples without a value, which do not count below
  double area = 0;          ///< of the samples with a value, in squared units of the shape
  double least = 0;
  double greatest = 0;
  double mean = 0;
  /// The least values that so much of the area is at or below.
  std::array<double, summary_percentiles.size()> percentiles{};
  std::optional<double> area_below = {};  ///< of samples below the threshold, where one is given
};

/// The summary of a field; NaN in place of values and 0 in place of areas where no sample has a value.
ThicknessSummary summarise(const ScalarField& field, std::optional<double> threshold = {});

/// A summary and what it is of.
struct NamedSummary {
  std::string name;
  ThicknessSummary summary;
};

/// How summaries are written.
struct SummaryWords {
  std::string unit = {};                 ///< of lengths; empty: not known
  std::optional<double> threshold = {};  ///< in that unit, as it was given to summarise()
};

/// A row a shape. Areas below the threshold are in percent of the area.
Table summary_table(std::span<const NamedSummary> summaries, const SummaryWords& words);

/// The summary with all digits: samples, missing, unit, area, min, percentiles, max, mean, below. Null for what is
/// unknown.
nlohmann::ordered_json summary_json(const NamedSummary& summary, const SummaryWords& words);

}  // namespace shapegauge
