#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/metrics/segmentation_errors.h"

namespace shapegauge {

/// A mesh and people's segmentations of it.
struct SegmentedModel {
  std::string id;
  std::filesystem::path mesh;
  std::vector<std::filesystem::path> people;  ///< .seg files
  int label = 0;                              ///< index of its class in SegmentationBenchmark::classes
};

/// Meshes that people segmented.
struct SegmentationBenchmark {
  std::vector<SegmentedModel> models;  ///< in natural order of their ids
  std::vector<std::string> classes;
  std::vector<std::string> without_people;  ///< ids of meshes that nobody segmented; they are not among the models
  SkippedEntries skipped = {};
};

/// The Princeton Segmentation Benchmark as it is handed out: meshes `off/N.off` and people's segmentations
/// `seg/N/*.seg`. Its classes are told by the number: 20 in a row from 1 on, as Chen et al. 2009 number them; other
/// names are a class "other". Throws InputError where a folder is absent or nobody segmented anything.
SegmentationBenchmark find_segmentation_benchmark(const std::filesystem::path& root);

/// Shapes that generate_dataset() made, each with one "person's" segmentation: the parts that it was made of. Throws
/// InputError as find_dataset().
SegmentationBenchmark find_generated_parts(const std::filesystem::path& root);

/// What is compared of segmentations.
struct SegmentationScoring {
  bool by_area = false;  ///< triangles count by their area; else all alike, as the benchmark's own tables have it
  bool cuts = true;      ///< the cut discrepancy too, which takes the longest
};

/// A mesh made ready to compare segmentations of it.
class SegmentationScorer {
 public:
  /// Throws InputError where the mesh is unusable or a cloud.
  SegmentationScorer(const Shape& mesh, const SegmentationScoring& scoring);

  /// The errors of one segmentation against another one that is taken for the truth.
  [[nodiscard]] SegmentationErrors errors(const std::vector<std::int32_t>& labels,
                                          const std::vector<std::int32_t>& truth) const;

  /// The mean errors of a segmentation against each of the people's; a cut discrepancy that is not defined does not
  /// count.
  [[nodiscard]] SegmentationErrors errors_against(const std::vector<std::int32_t>& labels,
                                                  const std::vector<std::vector<std::int32_t>>& people) const;

  /// The mean errors of each person's segmentation against each other one's: what can be reached. Of fewer than two
  /// people all are NaN.
  [[nodiscard]] SegmentationErrors errors_among(const std::vector<std::vector<std::int32_t>>& people) const;

 private:
  std::vector<double> weights_;
  std::vector<MeshEdge> edges_;
  std::int32_t vertices_ = 0;
  double radius_ = 0;
};

}  // namespace shapegauge
