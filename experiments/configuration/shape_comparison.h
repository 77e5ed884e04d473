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

/// One of the shapes of a shape comparison: a file or a generated shape.
struct ComparedShape {
  std::string name;                         ///< name of the shape in results
  std::filesystem::path file;               ///< shape file; empty for a generated shape
  std::optional<GeneratedModel> generated;  ///< settings of a generated shape; none for a file
  std::vector<Perturbation> perturbations;  ///< perturbation steps applied to the shape after reading
};

/// Complete, validated shape comparison with all defaults: compares shapes with a reference.
struct ShapeComparison : ExperimentSettings {
  std::vector<ComparedShape> shapes;     ///< shapes to compare, including the reference
  std::optional<std::size_t> reference;  ///< index of the reference in `shapes`; absent without a reference
  bool registered = true;  ///< true if shapes are aligned with the reference: values and normals are then compared
  std::vector<SignatureConfiguration> signatures;  ///< signatures to compare; all are histograms of fields
  std::string distance = "l1";                     ///< name of the distance between histograms
};

/// Formats the settings of a generated shape, as "generate" of a compared shape.
nlohmann::json to_json(const GeneratedModel& generated);

/// Formats a shape comparison as a configuration with all defaults.
nlohmann::json to_json(const ShapeComparison& comparison);

/// Reads and validates a shape comparison from a document. `source` is its name in messages; relative paths are
/// relative to `folder`. Throws InputError with the source, the path to the value, the fault and the most similar valid
/// word.
ShapeComparison comparison_from_json(const nlohmann::json& document, const std::string& source,
                                     const std::filesystem::path& folder);

}  // namespace shapegauge
