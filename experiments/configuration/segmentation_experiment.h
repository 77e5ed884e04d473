#pragma once

#include <cstdint>
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

namespace shapegauge {

/// The layout of data sets that people cut (find_segmentation_benchmark()).
inline constexpr std::string_view segmentation_layout = "psb_segmentation";

/// A way to cut shapes into parts, with its settings (segmentation/).
struct SegmentationMethod {
  std::string name;
  bool paper = false;  ///< the paper's pipeline, or else the best cut
  int parts = 0;       ///< wanted; 0: as many as there are (paper: the clusters of PaperSegmentationOptions)
  int patches = 150;   ///< best: as PartSegmentationOptions has them
  double least_probability = 0.5;           ///< best: the same
  double border_width = 0.03;               ///< best: BoundarySmoothingOptions::width
  bool offset_field = true;                 ///< paper: the SDF of the offset surface, or else the conventional one
  double offset = 0.05;                     ///< paper: of the offset surface, a fraction of the diagonal
  std::vector<Perturbation> perturbations;  ///< of a shape before it is cut
};

/// An experiment that cuts the shapes of a benchmark into parts and compares the parts with people's, checked, with all
/// defaults filled in.
struct SegmentationExperiment {
  std::string name;
  std::string description;
  DatasetLocation location;                   ///< on disk: a segmentation_layout or a layout of retrieval, or else
  std::optional<GeneratorOptions> generator;  ///< shapes that the program makes, whose parts are the truth
  std::vector<SegmentationMethod> methods;    ///< one or more
  bool by_area = false;                       ///< triangles count by their area; else all alike
  bool cuts = false;                          ///< the cut discrepancy too
  bool pictures = true;                       ///< in the report
  std::uint64_t seed = 1;                     ///< of the perturbations
  OnError on_error = OnError::stop;
};

/// The settings of a method but its name, and those of the experiment that are parameters.
/// @{
std::span<const Parameter> segmentation_method_parameters();
std::span<const Parameter> segmentation_experiment_parameters();
/// @}

/// The method that an entry of "segmentation" describes, which the schema has accepted. Throws ConfigurationError for
/// settings that do not go together.
SegmentationMethod segmentation_method(const nlohmann::json& settings);

/// Whether the document is one of a segmentation experiment.
bool is_segmentation(const nlohmann::json& document);

/// The experiment as JSON with all defaults filled in, in the form that configurations are read from.
nlohmann::json to_json(const SegmentationExperiment& experiment);
nlohmann::json to_json(const SegmentationMethod& method);

/// Reads a segmentation experiment from the document of a configuration, with the checks of configuration_from_json.
/// Throws InputError as comparison_from_json.
SegmentationExperiment segmentation_from_json(const nlohmann::json& document, const std::string& source,
                                              const std::filesystem::path& folder);

}  // namespace shapegauge
