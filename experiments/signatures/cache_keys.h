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

/// Returns the cache key of a result: SHA-256 of its kind, the program and the inputs `depends_on`.
std::string result_key(EntryKind kind, const nlohmann::json& depends_on);

/// Model that a shape is read from: the inputs of shape_key() other than settings.
struct ModelSource {
  std::string_view sha256;     ///< SHA-256 of the model's file
  std::filesystem::path file;  ///< path of the file; only its extension, which selects the format, is used
  std::string_view id;         ///< id of the model; only used by perturbations
  std::size_t index = 0;       ///< index of the model in the data set; only used by perturbations
};

/// Returns the key of a model's shape, perturbed and prepared. It does not depend on the file's path nor, without
/// perturbations, on the id.
std::string shape_key(const ModelSource& source, const PreparationOptions& preparation,
                      const std::vector<Perturbation>& perturbations, std::uint64_t seed);

/// Returns the key of the samples of a shape. `shape` is its shape_key().
std::string samples_key(const std::string& shape, const SamplePlan& plan);

/// Returns the key of the values of a field on a shape. `shape` is its shape_key().
std::string field_key(const std::string& shape, const Field& field);

/// Returns the key of a descriptor's features of a shape. `shape` is its shape_key(). `fields` has the field_key() of
/// each of the descriptor's fields. `learnt` is the learnt_key(), or empty if the descriptor does not learn.
std::string features_key(const std::string& shape, const DescriptorChoice& choice,
                         const std::vector<std::string>& fields, const std::string& learnt);

/// Returns the key of the features that a descriptor learns from a data set. `fields` has, for each shape, the
/// field_key() of each of the descriptor's fields.
std::string learnt_key(const DescriptorChoice& choice, const std::vector<std::vector<std::string>>& fields);

/// Returns the key of a picture of a shape, coloured by the field with the field_key() `field`.
std::string picture_key(const std::string& field, const PictureOptions& options, const Eigen::Vector3d& up);

/// Returns the key of an interactive view of a shape. `fields` has the field_key() of each field shown.
std::string view_key(const std::vector<std::string>& fields, const ShapeDrawing& drawing);

/// Returns the key of a distance matrix of signatures. `distance` identifies the distance: its name, or distance_of().
std::string distances_key(const Signatures& signatures, const std::string& distance);

/// Returns the argument `distance` of distances_key() for a descriptor's own distance: name and version.
std::string distance_of(const Descriptor& descriptor);

/// Returns the key of the segmentation of a shape by a method. The experiment has the seed of the perturbations and the
/// preparation options. `versions` are the cache versions of the method's algorithms.
std::string segmentation_key(const ModelSource& source, const SegmentationMethod& method,
                             const nlohmann::json& versions, const SegmentationExperiment& experiment);

/// Returns the key of the measurements of one shape in a shape comparison. `fields` has the field_key() of each
/// signature's field, and `histograms` the settings of its histogram; `reference` identifies the shape that it is
/// compared with; `version` is the cache version of the error measures. Run times depend on the number of threads.
std::string comparison_key(const std::vector<std::string>& fields,
                           const std::vector<HistogramConfiguration>& histograms, const std::string& reference,
                           int version, int threads);

}  // namespace shapegauge
