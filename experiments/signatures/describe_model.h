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

/// Returns the index in `fields` of the field with the same settings; the number of fields if there is none.
std::size_t index_of(std::span<const Field> fields, const Field& field);

/// Returns the index of the first signature that is a histogram of the field; nothing if there is none.
std::optional<std::size_t> first_histogram_of(const Field& field,
                                              const std::vector<SignatureConfiguration>& signatures);

/// Returns true if the field colours the pictures of the models in the report.
bool is_pictured(const Field& field, const Configuration& configuration);

/// Maximum number of fields in the interactive view of a model.
inline constexpr std::size_t max_viewed_fields = 6;

/// Returns the indices of the fields in the interactive views of models: first the field that colours their pictures,
/// then those of histograms. Empty if the configuration disables views.
std::vector<std::size_t> viewed_fields(std::span<const Field> fields, const Configuration& configuration);

/// Description of one field on one shape: range, outcomes and, if other shapes need them, values.
struct FieldDescription {
  Interval range;                ///< smallest and largest value of the field
  Eigen::VectorXf values;        ///< value at each sample, if a signature needs those of all shapes; otherwise empty
  Eigen::VectorXf weights;       ///< surface area that each sample represents; empty if `values` is empty
  FieldOutcomes outcomes;        ///< numbers of samples by outcome of the field
  std::optional<double> offset;  ///< automatically chosen offset, a fraction of the diagonal; none for other fields
  double seconds = 0;            ///< run time of the computation of the field in seconds
  std::string error = {};  ///< reason why the shape lacks the field, with OnError::skip; empty if it has the field
};

/// Description of one shape for signatures and reports, without its mesh.
struct ModelDescription : ShapeFacts {
  std::string sha256;                        ///< SHA-256 of the shape file; empty for a shape without file
  std::vector<FieldDescription> fields;      ///< descriptions of the distinct_fields(), in order
  std::vector<FeatureDescription> features;  ///< per signature: feature vector, empty if it depends on other shapes
  std::string shape_key;                     ///< shape_key() in the cache; empty if unknown
  std::string picture;                       ///< PNG bytes of model_picture(); empty without pictures
  std::string view;                          ///< JSON of model_view(); empty without views
};

SHAPEGAUGE_MEMBERS(FieldDescription, range, values, weights, outcomes, offset, seconds, error)
/// Returns references to the members, for the encoding of cache entries (codec.h).
inline auto members(ModelDescription& model) {
  return std::tie(static_cast<ShapeFacts&>(model), model.sha256, model.fields, model.features, model.shape_key,
                  model.picture, model.view);
}

/// Returns the error of the first field of a descriptor that the shape does not have; empty if it has all of them.
/// `fields` are the distinct_fields().
std::string error_of_fields(const ModelDescription& model, std::span<const Field> fields,
                            const DescriptorChoice& descriptor);

/// Returns, per signature, the reason why the shape does not have it: the first error of its field, its descriptor or
/// its parts. The string is empty for a signature that the shape has.
std::vector<std::string> signature_errors(const ModelDescription& model,
                                          const std::vector<SignatureConfiguration>& signatures,
                                          std::span<const Field> fields);

/// Describes the values of a field at samples with these area weights. Computes the histograms of the field whose range
/// does not depend on other shapes, and writes each to the entry of its signature in `features`. Keeps the values if a
/// histogram over the range of the data set, or a descriptor that learns, needs those of all shapes.
FieldDescription describe_field(const StoredField& values, const Eigen::VectorXd& weights, const Field& field,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::vector<FeatureDescription>& features);

/// Describes a shape by its fields, histograms, descriptors, picture and view. Throws InputError for an unusable shape
/// and, with OnError::stop, for a field or descriptor that the shape does not have. With OnError::skip, the description
/// records the error of such a field or descriptor.
ModelDescription describe_shape(CachedShape& bench, const Configuration& configuration, std::span<const Field> fields,
                                const ShapeDrawing& drawing);

/// Describes a model of the data set through the cache. Apart from run times, the description is the same, bit by bit,
/// whatever the state of the cache. `parallel` distributes the samples over threads. Throws InputError for an unusable
/// model.
ModelDescription describe_model(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                std::span<const Field> fields, bool parallel, Cache& cache);

/// Returns true if describe_model() has nothing left to compute for a model. This is so if all results are in the
/// cache, if the cache records that some cannot be computed (note_failure()), or if the model's file cannot be read.
bool is_described(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                  std::span<const Field> fields, Cache& cache);

/// Returns the description without the values of fields and the features, which are no longer needed when the tables of
/// signatures exist.
ModelDescription without_values(ModelDescription model);

/// Records in the cache, for is_described(), that some results of a model cannot be computed.
void note_failure(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                  std::span<const Field> fields, Cache& cache);

/// Returns the values at the samples and their area weights from the description of a field, in double precision. Both
/// are empty if the description has none.
ScalarField to_scalar_field(const FieldDescription& field);

}  // namespace shapegauge
