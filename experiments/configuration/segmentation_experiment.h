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

/// Layout of data sets with human segmentations (find_segmentation_benchmark()).
inline constexpr std::string_view segmentation_layout = "psb_segmentation";

/// Segmentation method with its settings.
struct SegmentationMethod {
  std::string name;
  SegmentationOptions options;
  std::vector<Perturbation> perturbations;  ///< of a shape before it is segmented
};

/// Complete, validated segmentation experiment with all defaults: segments the shapes of a benchmark and compares the
/// parts with human segmentations.
struct SegmentationExperiment : ExperimentSettings {
  DatasetLocation location;                   ///< on disk: segmentation_layout or a layout of retrieval data sets, or
  std::optional<GeneratorOptions> generator;  ///< generated shapes, whose parts are the ground truth
  std::vector<SegmentationMethod> methods;    ///< at least one
  TriangleWeights by = TriangleWeights::faces;
  bool cuts = false;              ///< also compute the cut discrepancy
  bool pictures = true;           ///< in the report
  UpAxis up = UpAxis::automatic;  ///< in pictures and views
};

/// Return the parameters of a method except its name, and those of the experiment.
/// @{
std::span<const Parameter> segmentation_method_parameters();
std::span<const Parameter> segmentation_experiment_parameters();
/// @}

/// Reads the method of an entry of "segmentation" after validation by the schema. Throws ConfigurationError for
/// inconsistent settings.
SegmentationMethod segmentation_method(const nlohmann::json& settings);

/// Formats the experiment as a configuration with all defaults.
nlohmann::json to_json(const SegmentationExperiment& experiment);
nlohmann::json to_json(const SegmentationMethod& method);

/// Reads a segmentation experiment from a document, with the checks of configuration_from_json(). Throws InputError as
/// comparison_from_json() does.
SegmentationExperiment segmentation_from_json(const nlohmann::json& document, const std::string& source,
                                              const std::filesystem::path& folder);

}  // namespace shapegauge
