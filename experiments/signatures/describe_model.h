#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/signatures/bench.h"

namespace shapegauge {

/// Field to compute on every shape, with the signatures that use it.
struct PlannedField {
  Field field;
  std::vector<std::size_t> signatures;  ///< indices of signatures that are histograms of it
  bool keep_values = false;             ///< for results that depend on the whole data set
};

/// Descriptor to compute on every shape, with its fields in the plan.
struct PlannedDescriptor {
  std::size_t signature = 0;        ///< index of the signature
  std::vector<std::size_t> fields;  ///< indices into the plan of fields
  bool learns = false;              ///< it must learn from all shapes first
};

/// Returns the distinct fields of the signatures in order of first use. Fields of equal settings are computed once.
std::vector<PlannedField> plan_fields(const std::vector<SignatureConfiguration>& signatures);

/// Returns the signatures that are descriptors, in order, with their fields in plan_fields().
std::vector<PlannedDescriptor> plan_descriptors(const std::vector<SignatureConfiguration>& signatures,
                                                std::span<const PlannedField> plan);

/// Returns true for the field that colours the models in the report.
bool is_pictured(const PlannedField& planned, const Configuration& configuration);

/// Maximum number of fields in the view of a model.
inline constexpr std::size_t max_viewed_fields = 6;

/// Returns the indices of the fields in the views of models: the one that colours their pictures, then those of
/// histogram signatures. Empty if the configuration disables views.
std::vector<std::size_t> viewed_fields(std::span<const PlannedField> plan, const Configuration& configuration);

/// Results for one field on one shape.
struct FieldDescription {
  Interval range;           ///< of the values
  Eigen::VectorXf values;   ///< kept if planned, otherwise empty; in single precision to save memory
  Eigen::VectorXf weights;  ///< sample weights; kept like the values
  FieldOutcomes outcomes;
  std::optional<double> offset;  ///< if the field chose one
  double seconds = 0;
  std::string error = {};  ///< why the shape has no values of it, with OnError::skip; otherwise empty
};

/// Description of one shape, without its mesh.
struct ModelDescription : ShapeFacts {
  std::string sha256;                        ///< of the file; empty for a shape without file
  std::vector<FieldDescription> fields;      ///< as in the plan
  std::vector<Eigen::VectorXf> histograms;   ///< by signature; empty if it depends on other shapes
  std::vector<FeatureDescription> features;  ///< by planned descriptor; empty for those that have yet to learn
  std::string shape_key;                     ///< shape_key() in the cache; empty if unknown
  std::string picture;                       ///< model_picture(), if configured
  std::string view;                          ///< model_view(), if configured
};

inline auto members(FieldDescription& field) {
  auto& [range, values, weights, outcomes, offset, seconds, error] = field;
  return std::tie(range, values, weights, outcomes, offset, seconds, error);
}
inline auto members(ModelDescription& model) {
  return std::tie(static_cast<ShapeFacts&>(model), model.sha256, model.fields, model.histograms, model.features,
                  model.shape_key, model.picture, model.view);
}

/// Returns, by signature, why the shape has none: the first error of its field, its descriptor or its parts. Empty for
/// signatures without an error.
std::vector<std::string> signature_errors(const ModelDescription& model,
                                          const std::vector<SignatureConfiguration>& signatures,
                                          std::span<const PlannedField> plan);

/// Describes computed values, of samples with these weights: their range, the histograms that do not depend on other
/// shapes, and the values if the plan keeps them.
FieldDescription describe_field(const StoredField& field, const Eigen::VectorXd& weights, const PlannedField& planned,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::vector<Eigen::VectorXf>& histograms);

/// Describes a shape by the planned fields and the configuration's descriptors, with at most that many faces in its
/// view (0: no view). Throws InputError for an unusable shape, and for a field or descriptor that the shape does not
/// have, or, with OnError::skip, records it.
ModelDescription describe_shape(Bench& bench, const Configuration& configuration, std::span<const PlannedField> plan,
                                Eigen::Index view_faces);

/// Describes a model of the data set through the cache. Apart from run times, the description is the same, bit by bit,
/// whatever the state of the cache. `parallel` distributes the samples over threads. Throws InputError for an unusable
/// model.
ModelDescription describe_model(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                std::span<const PlannedField> plan, bool parallel, Cache& cache);

/// Returns true if the cache has everything that describe_model() needs of a model.
bool is_described(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                  std::span<const PlannedField> plan, Cache& cache);

/// Returns the values kept by a description.
ScalarField kept_field(const FieldDescription& field);

/// Computes the histogram, over a range, of the values kept by a description.
Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options);

}  // namespace shapegauge
