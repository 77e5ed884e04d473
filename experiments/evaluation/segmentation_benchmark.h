// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/metrics/segmentation_errors.h"

namespace shapegauge {

/// Mesh with its human segmentations.
struct SegmentedModel {
  std::string id;
  std::filesystem::path mesh;
  std::vector<std::filesystem::path> people;  ///< .seg files
  int label = 0;                              ///< index into SegmentationBenchmark::classes
};

/// Meshes with human segmentations.
struct SegmentationBenchmark {
  std::vector<SegmentedModel> models;  ///< in natural order of their ids
  std::vector<std::string> classes;
  std::vector<std::string> without_people;  ///< ids of meshes without segmentations, which are not among the models
  SkippedEntries skipped = {};
};

/// Finds the Princeton Segmentation Benchmark as distributed: meshes `off/N.off` and human segmentations `seg/N/*.seg`.
/// Classes follow from the number, 20 consecutive ones from 1 on (Chen et al. 2009); other names have the class
/// "other". Throws InputError if a folder is absent or there are no segmentations.
SegmentationBenchmark find_segmentation_benchmark(const std::filesystem::path& root);

/// Finds shapes of generate_dataset(), each with one ground-truth segmentation: its parts. Throws InputError as
/// find_dataset() does.
SegmentationBenchmark find_generated_parts(const std::filesystem::path& root);

/// Options of scoring segmentations.
struct SegmentationScoring {
  TriangleWeights by = TriangleWeights::faces;
  bool cuts = true;  ///< also compute the cut discrepancy, which takes the longest
};

/// Scores segmentations of one mesh.
class SegmentationScorer {
 public:
  /// Throws InputError for an unusable mesh or a cloud.
  SegmentationScorer(const Shape& mesh, const SegmentationScoring& scoring);

  /// Computes the errors of a segmentation relative to a ground truth.
  [[nodiscard]] SegmentationErrors errors(const std::vector<std::int32_t>& labels,
                                          const std::vector<std::int32_t>& truth) const;

  /// Computes the mean errors of a segmentation relative to each human segmentation, ignoring undefined cut
  /// discrepancies.
  [[nodiscard]] SegmentationErrors errors_against(const std::vector<std::int32_t>& labels,
                                                  const std::vector<std::vector<std::int32_t>>& people) const;

  /// Computes the mean errors between all pairs of human segmentations, as a bound of what can be reached. All NaN for
  /// fewer than two.
  [[nodiscard]] SegmentationErrors errors_among(const std::vector<std::vector<std::int32_t>>& people) const;

 private:
  std::vector<double> weights_;
  std::vector<MeshEdge> edges_;
  std::int32_t vertices_ = 0;
  double radius_ = 0;
};

}  // namespace shapegauge
