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

/// Results for one shape.
struct SegmentedShape {
  std::string mesh_sha256;
  std::vector<std::string> people_sha256;
  std::vector<std::vector<std::int32_t>> labels;  ///< per method: part number of each face of the file
  bool has_polygons = false;                      ///< faces of the file are polygons
  std::vector<std::string> remarks;               ///< how perturbations fell short of their settings, with the method
  std::vector<std::string> warnings;              ///< samples without a reliable offset SDF, with the method
  std::vector<std::vector<double>> part_sizes;    ///< per method: the parts' fractions of the area, largest first
  /// Per method: Rand error of its parts relative to those of the same method without perturbations; NaN for methods
  /// without perturbations.
  std::vector<double> moved;
  std::vector<std::string> pictures;  ///< PNG files: first the parts of one human segmentation, if any, then by method
  std::string view = {};              ///< interactive view with the same parts, as JSON; may be empty
};

/// Results of a segmentation experiment.
struct SegmentationResults {
  SegmentationExperiment experiment;
  SegmentationBenchmark benchmark;     ///< usable shapes
  bool has_people = true;              ///< human segmentations exist
  SegmentationScores scores;           ///< of the methods, and of people for shapes with at least two segmentations
  std::vector<SegmentedShape> shapes;  ///< in the order of the benchmark
  std::vector<LeftOutShape> failures;
  std::vector<SegmentedModel> failed;  ///< shapes of the failures
  std::string classification_sha256;   ///< hash of the file of classes when the run began; empty if there is none
  CacheReport cache;
  int threads = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage
};

/// Returns the name of reference segmentations in reports: those of people, or of the generator.
std::string reference_name(const SegmentationExperiment& experiment);

/// Finds the shapes of a data set on disk, with their human segmentations if the layout has any. Throws InputError as
/// find_segmentation_benchmark() and find_dataset() do.
SegmentationBenchmark find_segmented_shapes(const DatasetLocation& location);

/// Returns the versions, by name, of the algorithms that a method's parts depend on.
nlohmann::json versions_of(const SegmentationMethod& method);

/// Runs a whole segmentation experiment: parts of each shape by each method, through the cache, and their errors.
/// Generated shapes are in RunContext::generated and are reused (prepare_generated()). Everything but the timings is
/// the same for any number of threads. Throws InputError for a shape that fails with OnError::stop and if no shape is
/// left; throws Interrupted.
SegmentationResults run_segmentation(const SegmentationExperiment& experiment, const RunContext& context);

/// Finds the parts of a part of the shapes and stores them in the cache. Throws as run_segmentation() does.
PartOutcome run_part_of_segmentation(const SegmentationExperiment& experiment, const RunContext& context,
                                     const Part& part);

}  // namespace shapegauge
