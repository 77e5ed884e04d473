#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"

namespace shapegauge {

/// A shape of a comparison.
struct ComparedShape {
  std::string name;
  std::filesystem::path file;               ///< where it is, or else
  std::optional<GeneratedModel> generated;  ///< how the program makes it
  std::vector<Perturbation> perturbations;  ///< applied to it after reading
};

/// An experiment that compares shapes with one of them, checked, with all defaults filled in.
struct ShapeComparison {
  std::string name;
  std::string description;
  std::vector<ComparedShape> shapes;
  std::optional<std::size_t> reference;  ///< index of the shape that the others are compared with, if any
  bool registered =
      true;  ///< whether the shapes lie where the reference lies: only then are values and normals compared
  std::uint64_t seed = 1;          ///< of the perturbations
  PreparationOptions preparation;  ///< of every shape, after them
  OnError on_error = OnError::stop;
  std::vector<SignatureConfiguration> signatures;  ///< histograms of a field, all of them
  std::string distance = "l1";
};

/// The comparison as JSON with all defaults filled in, in the form that configurations are read from.
nlohmann::json to_json(const ShapeComparison& comparison);

/// Reads a comparison from the document of a configuration, with the checks of configuration_from_json. `source` is
/// what messages call it; relative paths are relative to `folder`. Throws InputError with the source, the path to the
/// value, what is wrong and the nearest valid word.
ShapeComparison comparison_from_json(const nlohmann::json& document, const std::string& source,
                                     const std::filesystem::path& folder);

}  // namespace shapegauge
