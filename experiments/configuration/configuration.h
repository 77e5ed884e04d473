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

/// Options of the histogram of a field: its bins and the source of its range.
struct HistogramConfiguration {
  HistogramOptions options;
  HistogramRange range = HistogramRange::per_shape;
  Interval fixed;  ///< range with HistogramRange::fixed, in lengths of a shape of unit area
};

/// Settings of a signature: the histogram of a field, the features of a descriptor, distances derived from those of
/// other signatures, or, with none of these, a concatenation of signatures.
struct SignatureConfiguration {
  std::string name;
  std::optional<Field> field;                  ///< field of the histogram; none for other kinds of signatures
  HistogramConfiguration histogram;            ///< settings of the histogram; ignored without a field
  std::optional<DescriptorChoice> descriptor;  ///< descriptor that computes the features; none for other kinds
  std::optional<DerivedDistances> derived;     ///< settings of derived distances; none for other kinds
  std::vector<std::size_t>
      parts;  ///< indices of the signatures to concatenate or derive from; computation_order() has them earlier
};

/// Handling of models that cannot be used: stop the run, or skip them.
enum class OnError { stop, skip };
template <>
inline constexpr std::array<std::string_view, 2> words_of<OnError>{"stop", "skip"};

/// Rendering options of the report's pictures, common to all models.
struct PictureOptions {
  /// Field values at the ends of the colour map, which is proportional to the square root of (value - low) to emphasise
  /// thin parts. By default from 0 to the diameter of a sphere of unit area.
  Interval range = {.low = 0, .high = 0.5641895835477563};
  int width = 120;  ///< image width in pixels
  int height = 96;  ///< image height in pixels
};

/// Options of the HTML report of a run.
struct ReportConfiguration {
  bool wanted = true;                  ///< the run writes a report
  bool pictures = true;                ///< pictures of the models; requires a field to colour them
  std::size_t pictured_signature = 0;  ///< index of the signature whose pictured_field() colours the models
  PictureOptions picture_options;
  bool views = true;              ///< interactive 3D views of the models; requires pictures
  UpAxis up = UpAxis::automatic;  ///< vertical axis in pictures and views
};

/// Settings common to retrieval experiments, shape comparisons and segmentation experiments.
struct ExperimentSettings {
  std::string name;
  std::string description;
  std::uint64_t seed = 1;          ///< seed of the perturbations
  PreparationOptions preparation;  ///< preparation of every shape, after the perturbations
  OnError on_error = OnError::stop;
};

/// Validated configuration of a retrieval experiment, complete with all defaults.
struct Configuration : ExperimentSettings {
  std::optional<DatasetLocation> location;    ///< data set on disk; none for a generated one
  std::optional<GeneratorOptions> generator;  ///< options of a generated data set; none for one on disk
  std::vector<Perturbation> perturbations;    ///< steps applied to every model after reading
  std::vector<Protocol> protocols{Protocol::psb};
  EvaluationOptions evaluation;  ///< measures and other options, used under each protocol
  std::vector<SignatureConfiguration> signatures;
  std::string distance = "l1";  ///< name of the distance between signatures, in distances()
  bool keep_distances = true;   ///< write distance matrices to the result files
  ReportConfiguration report;
};

/// Return the parameters of sections of a configuration: its root ("seed", "on_error"), the "histogram" of a signature,
/// "evaluation" and "preparation".
/// @{
std::span<const Parameter> experiment_parameters();
std::span<const Parameter> histogram_parameters();
std::span<const Parameter> evaluation_parameters();
std::span<const Parameter> preparation_parameters();
/// @}

/// Returns the field of a signature that can colour a model: that of its histogram, or the first of its descriptor.
/// Null if the signature has none.
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

/// Formats the options of the data-set generator as a configuration's "generate", with all defaults.
nlohmann::json to_json(const GeneratorOptions& generator);

/// Formats a data set on disk as a configuration's "dataset", with absolute paths.
nlohmann::json to_json(const DatasetLocation& location);

/// Formats the settings that kinds of experiments share as entries of a configuration, with all defaults.
nlohmann::json shared_settings_json(const ExperimentSettings& settings);

/// Formats a configuration as a document, with all defaults and absolute paths. configuration_from_json() restores it.
nlohmann::json to_json(const Configuration& configuration);

/// Formats preparation options as a configuration's "preparation".
nlohmann::json to_json(const PreparationOptions& preparation);

}  // namespace shapegauge
