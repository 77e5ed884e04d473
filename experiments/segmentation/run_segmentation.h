// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/evaluation/segmentation_benchmark.h"
#include "shapegauge/experiments/evaluation/segmentation_tables.h"

namespace shapegauge {

/// Segmentations of one shape by all methods, with hashes of the input files, part sizes and pictures.
struct SegmentedShape {
  std::string mesh_sha256;                        ///< SHA-256 of the mesh file
  std::vector<std::string> people_sha256;         ///< SHA-256 of the file of each reference segmentation
  std::vector<std::vector<std::int32_t>> labels;  ///< per method: index of the part of each face of the mesh file
  bool has_polygons = false;                      ///< true if the mesh file has faces that are not triangles
  std::vector<std::string> remarks;               ///< sentences on perturbations weaker than requested
  std::vector<std::string> warnings;              ///< sentences on samples without a reliable offset SDF, per method
  std::vector<std::vector<double>> part_sizes;    ///< per method: each part's fraction of the surface area, descending
  /// Per method: Rand error between the segmentations with and without its perturbations; NaN for a method without
  /// perturbations.
  std::vector<double> perturbation_errors;
  std::vector<std::string> pictures;  ///< PNG images of segmentations: a human one, if any, then one per method
  std::string view = {};  ///< interactive 3D view of the segmentations, as JSON; empty if the report has no views
};

/// Results of a segmentation experiment: segmentations of all usable shapes, errors and failures.
struct SegmentationResults {
  SegmentationExperiment experiment;  ///< experiment with its settings
  SegmentationBenchmark benchmark;    ///< shapes that were segmented, without the failed ones
  bool has_people = true;             ///< true if at least one shape has a reference segmentation
  SegmentationScores scores;  ///< errors per method; also between people if every shape has several human segmentations
  std::vector<SegmentedShape> shapes;  ///< segmentations of the shapes, in the order of `benchmark`
  std::vector<LeftOutShape> failures;  ///< shapes that could not be segmented, with the reasons
  std::vector<SegmentedModel> failed;  ///< failed shapes with their files, in the order of `failures`
  std::string classification_sha256;   ///< SHA-256 of the classification file when the run began; empty if none
  CacheReport cache;                   ///< numbers of results found in the cache and computed
  int threads = 1;                     ///< number of threads of the run
  std::vector<std::pair<std::string, double>> timings;  ///< steps of the run with their times in seconds
};

/// Returns the name of reference segmentations in reports: "a person" for human ones, "reference" for those of the
/// generator.
std::string reference_name(const SegmentationExperiment& experiment);

/// Finds the shapes of a data set on disk, with their human segmentations if the layout has any. Throws InputError as
/// find_segmentation_benchmark() and find_dataset() do.
SegmentationBenchmark find_segmented_shapes(const DatasetLocation& location);

/// Returns the cache versions, by name, of the algorithms that the segmentations of a method depend on.
nlohmann::json versions_of(const SegmentationMethod& method);

/// Runs a whole segmentation experiment: segments each shape by each method, using the cache, and computes the errors.
/// Generated shapes are in the folder RunContext::generated and are reused (prepare_generated()). Everything but the
/// timings is the same for any number of threads. Throws InputError for a shape that fails with OnError::stop and if no
/// shape is left; throws Interrupted.
SegmentationResults run_segmentation(const SegmentationExperiment& experiment, const RunContext& context);

/// Segments one part (engine/part.h) of the shapes, for runs on several machines, and stores the segmentations in the
/// cache. Throws as run_segmentation() does.
PartOutcome run_part_of_segmentation(const SegmentationExperiment& experiment, const RunContext& context,
                                     const Part& part);

}  // namespace shapegauge
