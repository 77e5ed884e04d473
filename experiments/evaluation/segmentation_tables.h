#pragma once

#include <Eigen/Core>
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

/// What tables call one person against another.
inline constexpr const char* people_name = "people";

/// The errors of methods, and of people among themselves (last), on the meshes of a benchmark.
struct SegmentationScores {
  std::vector<std::string> ids;      ///< of the meshes
  std::vector<int> labels;           ///< of the meshes: indices of classes
  std::vector<std::string> classes;  ///< names
  std::vector<std::string> methods;
  std::vector<std::vector<SegmentationErrors>> errors;  ///< by method, then by mesh; NaN where one is not defined

  /// The mean of what is defined, over the meshes of a class or (-1) all; NaN where nothing is.
  [[nodiscard]] double mean(std::size_t method, double SegmentationErrors::*value, int label = -1) const;
};

/// Scores without errors yet.
SegmentationScores empty_scores(const SegmentationBenchmark& benchmark, std::vector<std::string> methods);

/// The errors of the segmentations in folders, one a method, named as the folder, with a file <id>.seg for each mesh of
/// the benchmark; and of people, last. The same for any number of threads. Throws InputError for the first mesh or
/// segmentation that cannot be used.
SegmentationScores score_segmentations(const SegmentationBenchmark& benchmark,
                                       const std::vector<std::filesystem::path>& folders,
                                       const SegmentationScoring& scoring);

/// A row for each method: its mean errors.
Table mean_table(const SegmentationScores& scores);

/// A row for each class, a column for each method: mean Rand errors.
Table class_table(const SegmentationScores& scores);

/// A row for each method and class: mean errors, to full precision.
Table class_error_table(const SegmentationScores& scores);

/// A row for each method and mesh: its errors, to full precision.
Table mesh_table(const SegmentationScores& scores);

/// The comparison of Rand errors by class; nothing where there are fewer than two classes or methods, or some error is
/// not defined.
std::optional<MethodComparison> rand_comparison(const SegmentationScores& scores);

/// A row for each method: its mean Rand error over classes, with its interval.
Table interval_table(const SegmentationScores& scores, const MethodComparison& comparison);

/// A row for each pair of methods: difference, interval, p-values, classes won.
Table pair_table(const SegmentationScores& scores, const MethodComparison& comparison);

}  // namespace shapegauge
