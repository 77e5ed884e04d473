#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/configuration/derived_distances.h"
#include "shapegauge/experiments/configuration/descriptor_choice.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/metrics/measures.h"
#include "shapegauge/metrics/protocol.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// Where the range of a histogram comes from (docs/reference/definitions.md#histograms).
enum class HistogramRange { per_shape, dataset, fixed };

/// How a field becomes a histogram.
struct HistogramConfiguration {
  HistogramOptions options;
  HistogramRange range = HistogramRange::per_shape;
  Interval fixed;  ///< with HistogramRange::fixed, in lengths of shapes of unit area
};

/// A signature: the histogram of a field, the features of a descriptor, distances derived from those of other
/// signatures, or, with none of these, signatures side by side.
struct SignatureConfiguration {
  std::string name;
  std::optional<Field> field;
  HistogramConfiguration histogram;            ///< of the field
  std::optional<DescriptorChoice> descriptor;  ///< instead of a field
  std::optional<DerivedDistances> derived;     ///< instead of both
  std::vector<std::size_t> parts;  ///< by index, the signatures to concatenate or to derive from; each comes earlier in
                                   ///< computation_order()
};

/// What to do with a model that cannot be used.
enum class OnError { stop, skip };

/// How the models of a run are drawn for its report; alike for all of them.
struct PictureOptions {
  /// Values with the ends of the colour map, which runs with the square root of (value - low) so that thin parts differ
  /// as well; by default from 0 to the diameter of a sphere of unit area.
  Interval range = {.low = 0, .high = 0.5641895835477563};
  int width = 120;  ///< pixels
  int height = 96;  ///< pixels
};

/// The page that a run of the experiment ends in.
struct ReportConfiguration {
  bool wanted = true;
  bool pictures = true;                ///< of the models; there is a field that colours them
  std::size_t pictured_signature = 0;  ///< the signature whose pictured_field() that is
  PictureOptions picture_options;
  bool views = true;  ///< of the models, that the reader can turn; where there are pictures
};

/// A whole experiment, checked, with all defaults filled in.
struct Configuration {
  std::string name;
  std::string description;
  std::optional<DatasetLocation> location;    ///< a data set on disk, or else
  std::optional<GeneratorOptions> generator;  ///< one that the program makes
  std::vector<Perturbation> perturbations;    ///< applied to every model after reading
  std::uint64_t seed = 1;                     ///< of the perturbations
  PreparationOptions preparation;             ///< of every model, then
  std::vector<Protocol> protocols{Protocol::psb};
  std::vector<Measure> measures;  ///< those of the protocols, unless others are named
  Ties ties = Ties::index;
  int minimum_class_size = 2;
  OnError on_error = OnError::stop;
  std::vector<SignatureConfiguration> signatures;
  std::string distance = "l1";
  bool keep_distances = true;  ///< as files of the results
  ReportConfiguration report;
};

/// The settings that are parameters, by the section of the configuration that has them: of the experiment itself, of a
/// signature's "histogram", and of "evaluation" and "preparation". Those of "generate" are the generator's.
/// @{
std::span<const Parameter> experiment_parameters();
std::span<const Parameter> histogram_parameters();
std::span<const Parameter> evaluation_parameters();
std::span<const Parameter> preparation_parameters();
/// @}

/// The field of a signature that can colour a model: its own, or the first of its descriptor's. Null where it has none.
const Field* pictured_field(const SignatureConfiguration& signature);

/// The index of a signature that is made from itself, directly or through others; nothing where there is none.
std::optional<std::size_t> part_of_itself(const std::vector<SignatureConfiguration>& signatures);

/// The signatures' indices, parts before the signatures that are made from them. None may be a part of itself.
std::vector<std::size_t> computation_order(const std::vector<SignatureConfiguration>& signatures);

/// The histogram's settings as JSON with all defaults filled in, in the form of a signature's "histogram".
nlohmann::json to_json(const HistogramConfiguration& histogram);

/// The signatures as JSON with all defaults filled in, in the form of a configuration's "signatures".
nlohmann::json to_json(const std::vector<SignatureConfiguration>& signatures);

/// The generator's settings as JSON, in the form of a configuration's "generate".
nlohmann::json to_json(const GeneratorOptions& generator);

/// A data set on disk, in the form of a configuration's "dataset", with absolute paths.
nlohmann::json to_json(const DatasetLocation& location);

/// The configuration as JSON with all defaults filled in, in the form that configurations are read from; paths are
/// absolute.
nlohmann::json to_json(const Configuration& configuration);

/// The options in the form of a configuration's "preparation".
nlohmann::json to_json(const PreparationOptions& preparation);

}  // namespace shapegauge
