#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/evaluation/segmentation_benchmark.h"
#include "shapegauge/experiments/evaluation/segmentation_tables.h"

namespace shapegauge {

/// What was found of one shape.
struct SegmentedShape {
  std::string mesh_sha256;
  std::vector<std::string> people_sha256;
  std::vector<std::vector<std::int32_t>> labels;  ///< by method; of each face of the file the number of its part
  bool has_polygons = false;                      ///< faces of the file are polygons
  std::vector<std::vector<double>> part_sizes;    ///< by method: the parts' fractions of the area, largest first
  /// By method with perturbations: the Rand Index error of its parts against those of the method without them; NaN for
  /// others.
  std::vector<double> moved;
  std::vector<std::string> pictures;  ///< PNG files: the first person's parts where there are any, then by method
};

/// All that a segmentation experiment found.
struct SegmentationResults {
  SegmentationExperiment experiment;
  SegmentationBenchmark benchmark;     ///< the shapes that could be used
  bool has_people = true;              ///< somebody cut the shapes
  SegmentationScores scores;           ///< of the methods, and of people where a shape has two
  std::vector<SegmentedShape> shapes;  ///< in the order of the benchmark's
  std::vector<LeftOutShape> failures;
  CacheReport cache;
  int threads = 1;
  std::vector<std::pair<std::string, double>> timings;  ///< seconds by stage
};

/// The parts of a shape by a method of the experiment, whose perturbations do not count here. Throws InputError as the
/// method's function.
std::vector<std::int32_t> segmented(const Shape& shape, const SegmentationMethod& method);

/// The versions of the algorithms that the parts by a method depend on, by their names.
nlohmann::json versions_of(const SegmentationMethod& method);

/// Runs a whole segmentation experiment: parts of each shape by each method, through the cache, and their errors.
/// Generated shapes lie in `generated`, and are made there unless they were before (prepare_generated()). All but the
/// timings is the same for any number of threads and of processes, of which rank 0 has the results. Collective. Throws
/// InputError for a shape that fails with OnError::stop and where no shape is left, and Interrupted.
SegmentationResults run_segmentation(const SegmentationExperiment& experiment, const std::filesystem::path& generated,
                                     const RunControl& control, Cache& cache, Communicator& ranks);

/// The same in this process alone.
SegmentationResults run_segmentation(const SegmentationExperiment& experiment, const std::filesystem::path& generated,
                                     const RunControl& control, Cache& cache);

}  // namespace shapegauge
