// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/signatures/model_picture.h"
#include "shapegauge/experiments/signatures/model_view.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Cache keys: SHA-256 of everything that a result depends on. These are the keys of its inputs, the parameters of the
/// step, the version of its algorithm, and the program: its release, compiler, libraries and processor type, which may
/// affect the last bits.

namespace shapegauge {

/// Returns the key of a result of that kind.
std::string result_key(EntryKind kind, const nlohmann::json& depends_on);

/// Input of a model's prepared shape, apart from the configuration.
struct ModelSource {
  std::string_view sha256;     ///< of the file's bytes
  std::filesystem::path file;  ///< its extension selects the format
  std::string_view id;         ///< only used by perturbations
  std::size_t index = 0;       ///< in the data set; only used by perturbations
};

/// Returns the key of a model's shape, perturbed and prepared. It does not depend on the file's path nor, without
/// perturbations, on the id.
std::string shape_key(const ModelSource& source, const PreparationOptions& preparation,
                      const std::vector<Perturbation>& perturbations, std::uint64_t seed);

/// Returns the key of samples of that shape.
std::string samples_key(const std::string& shape, const SamplePlan& plan);

/// Returns the key of a field on that shape.
std::string field_key(const std::string& shape, const Field& field);

/// Returns the key of a descriptor's features of that shape. `fields` are the keys of its fields; `learnt` is that of
/// its learnt features, or empty.
std::string features_key(const std::string& shape, const DescriptorChoice& choice,
                         const std::vector<std::string>& fields, const std::string& learnt);

/// Returns the key of what a descriptor learns from a data set. `fields` are the keys of its fields on each shape.
std::string learnt_key(const DescriptorChoice& choice, const std::vector<std::vector<std::string>>& fields);

/// Returns the key of a shape's picture coloured by that field.
std::string picture_key(const std::string& field, const PictureOptions& options, const Eigen::Vector3d& up);

/// Returns the key of a shape's view with those fields.
std::string view_key(const std::vector<std::string>& fields, const ShapeDrawing& drawing);

/// Returns the key of the distance matrix of signatures by the named distance.
std::string distances_key(const Signatures& signatures, const std::string& distance);

/// Returns the name and version that identify a descriptor's own distance in distances_key().
std::string distance_of(const Descriptor& descriptor);

/// Returns the key of a shape's parts by a method of the experiment, which has the seed of the perturbations and the
/// preparation. `versions` are those of the method's algorithms.
std::string segmentation_key(const ModelSource& source, const SegmentationMethod& method,
                             const nlohmann::json& versions, const SegmentationExperiment& experiment);

/// Returns the key of what a comparison measures on a shape. `fields` are the keys of the fields of its signatures, and
/// `histograms` their histograms; `reference` identifies the shape that it is compared with; `version` is that of the
/// errors. Run times depend on the number of threads.
std::string comparison_key(const std::vector<std::string>& fields,
                           const std::vector<HistogramConfiguration>& histograms, const std::string& reference,
                           int version, int threads);

}  // namespace shapegauge
