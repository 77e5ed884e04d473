// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/members.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/signatures/bench.h"

namespace shapegauge {

/// Returns the distinct fields of the signatures in order of first use. Fields of equal settings are computed once.
std::vector<Field> distinct_fields(const std::vector<SignatureConfiguration>& signatures);

/// Returns the index of the field with these settings; their number if there is none.
std::size_t index_of(std::span<const Field> fields, const Field& field);

/// Returns the first signature that is a histogram of the field, if there is one.
std::optional<std::size_t> first_histogram_of(const Field& field,
                                              const std::vector<SignatureConfiguration>& signatures);

/// Returns true for the field that colours the models in the report.
bool is_pictured(const Field& field, const Configuration& configuration);

/// Maximum number of fields in the view of a model.
inline constexpr std::size_t max_viewed_fields = 6;

/// Returns the indices of the fields in the views of models: the one that colours their pictures, then those of
/// histogram signatures. Empty if the configuration disables views.
std::vector<std::size_t> viewed_fields(std::span<const Field> fields, const Configuration& configuration);

/// Results for one field on one shape.
struct FieldDescription {
  Interval range;           ///< of the values
  Eigen::VectorXf values;   ///< if a signature depends on those of all shapes; in single precision to save memory
  Eigen::VectorXf weights;  ///< of the samples; empty without the values
  FieldOutcomes outcomes;
  std::optional<double> offset;  ///< if the field chose one
  double seconds = 0;
  std::string error = {};  ///< why the shape has no values of it, with OnError::skip; otherwise empty
};

/// Description of one shape, without its mesh.
struct ModelDescription : ShapeFacts {
  std::string sha256;                        ///< of the file; empty for a shape without file
  std::vector<FieldDescription> fields;      ///< of distinct_fields()
  std::vector<FeatureDescription> features;  ///< per signature, also histograms; empty if it depends on other shapes
  std::string shape_key;                     ///< shape_key() in the cache; empty if unknown
  std::string picture;                       ///< model_picture(), if configured
  std::string view;                          ///< model_view(), if configured
};

SHAPEGAUGE_MEMBERS(FieldDescription, range, values, weights, outcomes, offset, seconds, error)
inline auto members(ModelDescription& model) {
  return std::tie(static_cast<ShapeFacts&>(model), model.sha256, model.fields, model.features, model.shape_key,
                  model.picture, model.view);
}

/// Returns the first error of a descriptor's fields on the shape; empty if it has them all.
std::string error_of_fields(const ModelDescription& model, std::span<const Field> fields,
                            const DescriptorChoice& descriptor);

/// Returns, by signature, why the shape has none: the first error of its field, its descriptor or its parts. Empty for
/// signatures without an error.
std::vector<std::string> signature_errors(const ModelDescription& model,
                                          const std::vector<SignatureConfiguration>& signatures,
                                          std::span<const Field> fields);

/// Describes computed values of a field, of samples with these weights: their range, and the values if a signature
/// depends on those of all shapes. Adds the other histograms of the field to the features by signature.
FieldDescription describe_field(const StoredField& values, const Eigen::VectorXd& weights, const Field& field,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::vector<FeatureDescription>& features);

/// Describes a shape by the fields and the configuration's descriptors. Throws InputError for an unusable shape, and
/// for a field or descriptor that the shape does not have, or, with OnError::skip, records it.
ModelDescription describe_shape(Bench& bench, const Configuration& configuration, std::span<const Field> fields,
                                const ShapeDrawing& drawing);

/// Describes a model of the data set through the cache. Apart from run times, the description is the same, bit by bit,
/// whatever the state of the cache. `parallel` distributes the samples over threads. Throws InputError for an unusable
/// model.
ModelDescription describe_model(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                std::span<const Field> fields, bool parallel, Cache& cache);

/// Returns true if describe_model() has nothing left to compute for a model: the cache has everything it needs, or the
/// note that some of it cannot be computed, or the model's file cannot be read.
bool is_described(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                  std::span<const Field> fields, Cache& cache);

/// Returns the description without values and features, when these are in tables.
ModelDescription without_values(ModelDescription model);

/// Notes in the cache, for is_described(), that some results of a model cannot be computed.
void note_failure(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                  std::span<const Field> fields, Cache& cache);

/// Returns the values kept by a description.
ScalarField kept_field(const FieldDescription& field);

}  // namespace shapegauge
