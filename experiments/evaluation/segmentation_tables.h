// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/evaluation/segmentation_benchmark.h"
#include "shapegauge/metrics/method_comparison.h"
#include "shapegauge/metrics/segmentation_errors.h"

namespace shapegauge {

/// Name in tables of the comparison between people.
inline constexpr const char* people_name = "people";

/// Errors of methods and, last, between people, on the meshes of a benchmark.
struct SegmentationScores {
  std::vector<std::string> ids;      ///< of the meshes
  std::vector<int> labels;           ///< per mesh: index of its class
  std::vector<std::string> classes;  ///< names
  std::vector<std::string> methods;
  std::vector<std::vector<SegmentationErrors>> errors;  ///< per method, then by mesh; NaN if undefined

  /// Returns the mean of the defined values over the meshes of a class or (-1) all; NaN if there are none.
  [[nodiscard]] double mean(std::size_t method, double SegmentationErrors::*value, int label = -1) const;
};

/// Makes scores without errors.
SegmentationScores empty_scores(const SegmentationBenchmark& benchmark, std::vector<std::string> methods);

/// Scores the segmentations in folders, one per method, named after the folder, with a file `ID.seg` for each mesh of
/// the benchmark; last those between people. The same for any number of threads. Throws InputError for the first
/// unusable mesh or segmentation.
SegmentationScores score_segmentations(const SegmentationBenchmark& benchmark,
                                       const std::vector<std::filesystem::path>& folders,
                                       const SegmentationScoring& scoring);

/// Makes a table with a row for each method: its mean errors.
TextTable mean_table(const SegmentationScores& scores);

/// Makes a table with a row for each class and a column for each method: mean Rand errors.
TextTable class_table(const SegmentationScores& scores);

/// Makes a table with a row for each method and class: mean errors in full precision.
TextTable class_error_table(const SegmentationScores& scores);

/// Makes a table with a row for each method and mesh: its errors in full precision.
TextTable mesh_table(const SegmentationScores& scores);

/// Compares Rand errors by class; nothing for fewer than two classes or methods, or if an error is undefined.
std::optional<MethodComparison> rand_comparison(const SegmentationScores& scores);

/// Makes a table with a row for each method: its mean Rand error over classes, with its confidence interval.
TextTable interval_table(const SegmentationScores& scores, const MethodComparison& comparison);

/// Makes a table with a row for each pair of methods: difference, interval, p-values, classes won.
TextTable pair_table(const SegmentationScores& scores, const MethodComparison& comparison);

}  // namespace shapegauge
