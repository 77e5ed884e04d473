// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/configuration/derived_distances.h"
#include "shapegauge/experiments/configuration/descriptor_choice.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/protocol.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// Source of the range of a histogram (docs/reference/definitions.md#histograms).
enum class HistogramRange { per_shape, dataset, fixed };
template <>
inline constexpr std::array<std::string_view, 3> words_of<HistogramRange>{"per-shape", "dataset", "fixed"};

/// Options of the histogram of a field.
struct HistogramConfiguration {
  HistogramOptions options;
  HistogramRange range = HistogramRange::per_shape;
  Interval fixed;  ///< with HistogramRange::fixed, in lengths of shapes of unit area
};

/// Signature: the histogram of a field, the features of a descriptor, distances derived from those of other signatures,
/// or, with none of these, a concatenation of signatures.
struct SignatureConfiguration {
  std::string name;
  std::optional<Field> field;
  HistogramConfiguration histogram;            ///< of the field
  std::optional<DescriptorChoice> descriptor;  ///< instead of a field
  std::optional<DerivedDistances> derived;     ///< instead of a field and a descriptor
  std::vector<std::size_t>
      parts;  ///< by index: signatures to concatenate or to derive from; they come earlier in computation_order()
};

/// Handling of models that cannot be used.
enum class OnError { stop, skip };
template <>
inline constexpr std::array<std::string_view, 2> words_of<OnError>{"stop", "skip"};

/// Rendering options of the report's pictures, common to all models.
struct PictureOptions {
  /// Values at the ends of the colour map, which is proportional to the square root of (value - low) to emphasise thin
  /// parts. By default from 0 to the diameter of a sphere of unit area.
  Interval range = {.low = 0, .high = 0.5641895835477563};
  int width = 120;  ///< pixels
  int height = 96;  ///< pixels
};

/// Options of the report of a run.
struct ReportConfiguration {
  bool wanted = true;
  bool pictures = true;                ///< pictures of the models; requires a field to colour them
  std::size_t pictured_signature = 0;  ///< signature whose pictured_field() colours them
  PictureOptions picture_options;
  bool views = true;              ///< interactive 3D views of the models; requires pictures
  UpAxis up = UpAxis::automatic;  ///< in pictures and views
};

/// Settings that experiments on shapes share.
struct ExperimentSettings {
  std::string name;
  std::string description;
  std::uint64_t seed = 1;          ///< seed of the perturbations
  PreparationOptions preparation;  ///< of every shape, after the perturbations
  OnError on_error = OnError::stop;
};

/// Complete, validated experiment with all defaults.
struct Configuration : ExperimentSettings {
  std::optional<DatasetLocation> location;    ///< data set on disk, or
  std::optional<GeneratorOptions> generator;  ///< generated data set
  std::vector<Perturbation> perturbations;    ///< applied to every model after reading
  std::vector<Protocol> protocols{Protocol::psb};
  EvaluationOptions evaluation;  ///< under each of the protocols, whose measures are the default
  std::vector<SignatureConfiguration> signatures;
  std::string distance = "l1";
  bool keep_distances = true;  ///< in result files
  ReportConfiguration report;
};

/// Return the parameters of a section of the configuration: the experiment itself, a signature's "histogram",
/// "evaluation" and "preparation". Those of "generate" are the generator's.
/// @{
std::span<const Parameter> experiment_parameters();
std::span<const Parameter> histogram_parameters();
std::span<const Parameter> evaluation_parameters();
std::span<const Parameter> preparation_parameters();
/// @}

/// Returns the field that can colour a model: the signature's own, or the first of its descriptor. Null if it has none.
const Field* pictured_field(const SignatureConfiguration& signature);

/// Returns the index of a signature that depends on itself, directly or indirectly, if there is one.
std::optional<std::size_t> part_of_itself(const std::vector<SignatureConfiguration>& signatures);

/// Returns the signatures' indices in topological order: parts before the signatures made from them. Dependencies must
/// be acyclic.
std::vector<std::size_t> computation_order(const std::vector<SignatureConfiguration>& signatures);

/// Formats a histogram's settings as a signature's "histogram", with all defaults.
nlohmann::json to_json(const HistogramConfiguration& histogram);

/// Formats signatures as a configuration's "signatures", with all defaults.
nlohmann::json to_json(const std::vector<SignatureConfiguration>& signatures);

/// Formats the generator's settings as a configuration's "generate".
nlohmann::json to_json(const GeneratorOptions& generator);

/// Formats a data set on disk as a configuration's "dataset", with absolute paths.
nlohmann::json to_json(const DatasetLocation& location);

/// Formats the shared settings, with all defaults.
nlohmann::json shared_settings_json(const ExperimentSettings& settings);

/// Formats a configuration with all defaults and absolute paths; reading restores it.
nlohmann::json to_json(const Configuration& configuration);

/// Formats preparation options as a configuration's "preparation".
nlohmann::json to_json(const PreparationOptions& preparation);

}  // namespace shapegauge
