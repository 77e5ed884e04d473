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

/// Name, in place of a method, of errors between human segmentations in tables.
inline constexpr const char* people_name = "people";

/// Segmentation errors of methods on the meshes of a benchmark. The last method may be people_name: errors between
/// human segmentations.
struct SegmentationScores {
  std::vector<std::string> ids;                         ///< ids of the meshes
  std::vector<int> labels;                              ///< class of each mesh, as an index into `classes`
  std::vector<std::string> classes;                     ///< names of the classes
  std::vector<std::string> methods;                     ///< names of the methods
  std::vector<std::vector<SegmentationErrors>> errors;  ///< errors[m][i] of method m on mesh i; NaN if undefined

  /// Returns the mean of the error `value` of a method (index in `methods`) over the meshes of the class with index
  /// `label`, or over all meshes if it is -1. Ignores NaN; returns NaN if no error is defined.
  [[nodiscard]] double mean(std::size_t method, double SegmentationErrors::*value, int label = -1) const;
};

/// Makes the scores of methods on the meshes of a benchmark with all errors 0, for the caller to set.
SegmentationScores empty_scores(const SegmentationBenchmark& benchmark, std::vector<std::string> methods);

/// Computes the errors of segmentations in folders. Each folder is a method of the same name, with a file `ID.seg` for
/// each mesh of the benchmark; the last method is people_name. The same for any number of threads. Throws InputError
/// for the first unusable mesh or segmentation.
SegmentationScores score_segmentations(const SegmentationBenchmark& benchmark,
                                       const std::vector<std::filesystem::path>& folders,
                                       const SegmentationScoring& scoring);

/// Makes a table with a row for each method: its mean segmentation errors over all meshes.
TextTable mean_table(const SegmentationScores& scores);

/// Makes a table with a row for each class and a column for each method: the mean Rand error.
TextTable class_table(const SegmentationScores& scores);

/// Makes a table with a row for each method and class: mean errors over the meshes of the class, in full precision.
TextTable class_error_table(const SegmentationScores& scores);

/// Makes a table with a row for each method and mesh: all segmentation errors, in full precision.
TextTable mesh_table(const SegmentationScores& scores);

/// Tests the differences between methods in mean Rand error, with classes as the units. Returns nothing for fewer than
/// two classes or methods, or if an error is undefined.
std::optional<MethodComparison> rand_comparison(const SegmentationScores& scores);

/// Makes a table with a row for each method: its mean Rand error over classes, with the confidence interval.
TextTable interval_table(const SegmentationScores& scores, const MethodComparison& comparison);

/// Makes a table with a row for each pair of methods: difference of their mean Rand errors, its confidence interval,
/// p-values, and the number of classes in which the first method is better.
TextTable pair_table(const SegmentationScores& scores, const MethodComparison& comparison);

}  // namespace shapegauge
