// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/metrics/segmentation_errors.h"

namespace shapegauge {

/// Mesh of a segmentation benchmark with the files of its reference segmentations.
struct SegmentedModel {
  std::string id;                             ///< id of the mesh
  std::filesystem::path mesh;                 ///< mesh file
  std::vector<std::filesystem::path> people;  ///< .seg files of the reference segmentations, one per person
  int label = 0;                              ///< class: index into SegmentationBenchmark::classes
};

/// Meshes with reference segmentations, such as human ones, and their classes.
struct SegmentationBenchmark {
  std::vector<SegmentedModel> models;       ///< meshes with their segmentations, in natural order of ids
  std::vector<std::string> classes;         ///< names of the classes, by class index
  std::vector<std::string> without_people;  ///< ids of meshes that are left out because they have no human segmentation
  SkippedEntries skipped = {};              ///< numbers of files and folders that are not meshes of the benchmark
};

/// Finds the files of the Princeton Segmentation Benchmark as distributed: meshes `off/N.off` and human segmentations
/// `seg/N/*.seg`. Classes follow from the number N: 20 consecutive meshes per class, from 1 on (Chen et al. 2009).
/// Meshes with other names are of class "other". Throws InputError if a folder is absent or there are no segmentations.
SegmentationBenchmark find_segmentation_benchmark(const std::filesystem::path& root);

/// Finds the shapes that generate_dataset() has written, each with its parts as the only reference segmentation. Throws
/// InputError as find_dataset() does.
SegmentationBenchmark find_generated_parts(const std::filesystem::path& root);

/// Options of the errors of segmentations.
struct SegmentationScoring {
  TriangleWeights by = TriangleWeights::faces;  ///< weights of triangles in the errors: equal, or by area
  bool cuts = true;                             ///< true to also compute the cut discrepancy, the slowest error
};

/// Computes errors of segmentations of one mesh. A segmentation is given as one label per triangle.
class SegmentationScorer {
 public:
  /// Computes the weights and edges of the mesh. Throws InputError for an unusable mesh or a point cloud.
  SegmentationScorer(const Shape& mesh, const SegmentationScoring& scoring);

  /// Computes the errors of a segmentation relative to a ground truth.
  [[nodiscard]] SegmentationErrors errors(const std::vector<std::int32_t>& labels,
                                          const std::vector<std::int32_t>& truth) const;

  /// Computes the mean errors of a segmentation relative to each human segmentation, ignoring undefined cut
  /// discrepancies.
  [[nodiscard]] SegmentationErrors mean_errors_against(const std::vector<std::int32_t>& labels,
                                                       const std::vector<std::vector<std::int32_t>>& people) const;

  /// Computes the mean errors over all pairs of human segmentations, as a bound of what methods can reach. Returns NaN
  /// for fewer than two segmentations.
  [[nodiscard]] SegmentationErrors mean_errors_among(const std::vector<std::vector<std::int32_t>>& people) const;

 private:
  std::vector<double> weights_;  ///< weight of each triangle in the errors; empty for equal weights
  std::vector<MeshEdge> edges_;  ///< edges of the mesh, for the cut discrepancy
  std::int32_t vertices_ = 0;    ///< number of vertices of the mesh
  double radius_ = 0;            ///< mean distance of the surface from its centroid; 0 without the cut discrepancy
};

}  // namespace shapegauge
