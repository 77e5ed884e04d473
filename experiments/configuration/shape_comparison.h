// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"

namespace shapegauge {

/// Shape of a comparison.
struct ComparedShape {
  std::string name;
  std::filesystem::path file;               ///< file of the shape, or
  std::optional<GeneratedModel> generated;  ///< generated shape
  std::vector<Perturbation> perturbations;  ///< applied after reading
};

/// Complete, validated shape comparison with all defaults: compares shapes with a reference.
struct ShapeComparison : ExperimentSettings {
  std::vector<ComparedShape> shapes;
  std::optional<std::size_t> reference;  ///< index of the reference shape, if any
  bool registered = true;  ///< shapes are aligned with the reference; required for comparing values and normals
  std::vector<SignatureConfiguration> signatures;  ///< histograms of a field only
  std::string distance = "l1";
};

/// Formats the settings of a generated shape.
nlohmann::json to_json(const GeneratedModel& generated);

/// Formats the comparison as a configuration with all defaults.
nlohmann::json to_json(const ShapeComparison& comparison);

/// Reads a comparison from a document, with the checks of configuration_from_json(). `source` is its name in messages;
/// relative paths are relative to `folder`. Throws InputError with the source, the path to the value, the fault and the
/// nearest valid word.
ShapeComparison comparison_from_json(const nlohmann::json& document, const std::string& source,
                                     const std::filesystem::path& folder);

}  // namespace shapegauge
