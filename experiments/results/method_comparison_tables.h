// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/metrics/method_comparison.h"

namespace shapegauge {

/// Makes a table with a row for each method: a letter, its name, and its average for each measure with the confidence
/// interval. A score is followed by the letters of the methods that it is significantly better than: p, after Holm's
/// correction, at most 1 - confidence. The best of each measure is bold. `comparisons` has one per measure.
TextTable comparison_summary(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                             const ComparisonOptions& options, const ScoreStyle& style);

/// Makes a table with a row for each measure and pair of methods: measure, first, second, difference, its interval
/// (low, high), p, p_holm, p_tukey, effect_size, and the numbers of queries that the first method wins, ties, loses.
/// With `exact`, p-values have all digits, for files; otherwise they are rounded.
TextTable pairs_table(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                      const ScoreStyle& style, bool exact);

/// Formats the contents of comparison_summary() and pairs_table() as JSON, with scores as fractions, and the settings.
nlohmann::ordered_json comparison_json(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                                       const ComparisonOptions& options);

/// Returns a warning if too few units (classes or queries) or resamples make significant differences impossible;
/// otherwise nothing.
std::optional<std::string> few_units_warning(const MethodComparison& comparison, const ComparisonOptions& options);

}  // namespace shapegauge
