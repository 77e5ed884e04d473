// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/metrics/segmentation_errors.h"
#include "shapegauge/segmentation/segment_shape.h"

namespace shapegauge {

/// Name of the layout of data sets with human segmentations (find_segmentation_benchmark()).
inline constexpr std::string_view segmentation_layout = "psb_segmentation";

/// Segmentation method of an experiment: its name and options, and perturbations of the shapes that it segments.
struct SegmentationMethod {
  std::string name;                         ///< name of the method in results
  SegmentationOptions options;              ///< algorithm and its options
  std::vector<Perturbation> perturbations;  ///< perturbation steps applied to a shape before it is segmented
};

/// Complete, validated segmentation experiment with all defaults: segments the shapes of a benchmark and compares the
/// parts with human segmentations.
struct SegmentationExperiment : ExperimentSettings {
  DatasetLocation location;                   ///< data set on disk, for segmentation or retrieval; unused if generated
  std::optional<GeneratorOptions> generator;  ///< options of generated shapes; absent for a data set on disk
  std::vector<SegmentationMethod> methods;    ///< methods to compare, at least one
  TriangleWeights by = TriangleWeights::faces;  ///< weights of triangles in the errors: equal, or by area
  bool cuts = false;                            ///< true to also compute the cut discrepancy
  bool pictures = true;                         ///< true to show pictures of the parts in the report
  UpAxis up = UpAxis::automatic;                ///< vertical axis in pictures and views
};

/// Return the parameters of a segmentation method, without its name and perturbations, and of a segmentation
/// experiment.
/// @{
std::span<const Parameter> segmentation_method_parameters();
std::span<const Parameter> segmentation_experiment_parameters();
/// @}

/// Reads a segmentation method from an entry of the list "segmentation", which the schema has accepted. Throws
/// ConfigurationError for inconsistent settings.
SegmentationMethod segmentation_method(const nlohmann::json& settings);

/// Formats a segmentation experiment as a configuration, or a method as an entry of "segmentation", with all defaults.
nlohmann::json to_json(const SegmentationExperiment& experiment);
nlohmann::json to_json(const SegmentationMethod& method);

/// Reads and validates a segmentation experiment from a document. `source` is its name in messages; relative paths are
/// relative to `folder`. Throws InputError as comparison_from_json() does.
SegmentationExperiment segmentation_from_json(const nlohmann::json& document, const std::string& source,
                                              const std::filesystem::path& folder);

}  // namespace shapegauge
