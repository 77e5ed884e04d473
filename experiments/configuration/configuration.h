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

/// Range of a histogram: from the smallest to the largest value on each shape or in the data set, or a fixed interval.
enum class HistogramRange { per_shape, dataset, fixed };
template <>
inline constexpr std::array<std::string_view, 3> words_of<HistogramRange>{"per-shape", "dataset", "fixed"};

/// Options of the histogram of a field: its bins and its range.
struct HistogramConfiguration {
  HistogramOptions options;                          ///< number of bins and other options
  HistogramRange range = HistogramRange::per_shape;  ///< how the range of the bins is chosen
  Interval fixed;  ///< range of the bins for HistogramRange::fixed, in units of a shape of area 1
};

/// Settings of a signature: the histogram of a field, the features of a descriptor, distances derived from those of
/// other signatures, or, with none of these, a concatenation of signatures.
struct SignatureConfiguration {
  std::string name;                            ///< unique name of the signature
  std::optional<Field> field;                  ///< field of the histogram; none for other kinds of signatures
  HistogramConfiguration histogram;            ///< settings of the histogram; ignored without a field
  std::optional<DescriptorChoice> descriptor;  ///< descriptor that computes the features; none for other kinds
  std::optional<DerivedDistances> derived;     ///< settings of derived distances; none for other kinds
  std::vector<std::size_t>
      parts;  ///< indices in Configuration::signatures of those concatenated or combined; empty for other kinds
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
  bool enabled = true;   ///< true to write a report
  bool pictures = true;  ///< true to show pictures of the models, coloured by a field; false if no signature has one
  std::size_t pictured_signature = 0;  ///< index in Configuration::signatures; its pictured_field() colours models
  PictureOptions picture_options;      ///< colour range and size of the pictures
  bool views = true;                   ///< true to show interactive 3D views of the models; only with pictures
  UpAxis up = UpAxis::automatic;       ///< vertical axis in pictures and views
};

/// Settings common to retrieval experiments, shape comparisons and segmentation experiments.
struct ExperimentSettings {
  std::string name;                  ///< name of the experiment
  std::string description;           ///< description for reports; may be empty
  std::uint64_t seed = 1;            ///< seed of the random numbers of perturbations
  PreparationOptions preparation;    ///< preparation of every shape, after the perturbations
  OnError on_error = OnError::stop;  ///< handling of shapes that cannot be used
};

/// Validated configuration of a retrieval experiment, complete with all defaults.
struct Configuration : ExperimentSettings {
  std::optional<DatasetLocation> location;         ///< data set on disk; none for a generated one
  std::optional<GeneratorOptions> generator;       ///< options of a generated data set; none for one on disk
  std::vector<Perturbation> perturbations;         ///< perturbation steps applied to every model after reading
  std::vector<Protocol> protocols{Protocol::psb};  ///< evaluation protocols; scores are computed under each
  EvaluationOptions evaluation;                    ///< measures and other options, used under each protocol
  std::vector<SignatureConfiguration> signatures;  ///< signatures to compute, compare and evaluate
  std::string distance = "l1";                     ///< name in distances() of the distance between signatures
  bool keep_distances = true;                      ///< true to write each distance matrix as a result file
  ReportConfiguration report;                      ///< options of the HTML report
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

/// Returns the index of a signature that is computed from itself, directly or through other signatures; nothing if
/// dependencies are acyclic.
std::optional<std::size_t> find_cyclic_signature(const std::vector<SignatureConfiguration>& signatures);

/// Returns the signatures' indices in topological order: each signature after those that it is computed from
/// (SignatureConfiguration::parts). Dependencies must be acyclic.
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
