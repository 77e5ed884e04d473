#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"

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
inline constexpr std::size_t most_viewed_fields = 6;

/// Returns the indices of the fields in the views of models: the one that colours their pictures, then those of
/// histogram signatures. Empty if the configuration disables views.
std::vector<std::size_t> viewed_fields(std::span<const PlannedField> plan, const Configuration& configuration);

/// Results for one field on one shape.
struct FieldDescription {
  Interval range;           ///< of the values
  Eigen::VectorXf values;   ///< kept if planned, otherwise empty; in single precision to save memory
  Eigen::VectorXf weights;  ///< sample weights; kept and stored like the values
  FieldOutcomes outcomes;
  std::optional<double> offset;  ///< if the field chose one
  double seconds = 0;
  std::string error = {};  ///< why the shape has no values of it, with OnError::skip; otherwise empty
};

/// Results for one descriptor on one shape.
struct FeatureDescription {
  Eigen::VectorXf features;
  double seconds = 0;      ///< without its fields
  std::string error = {};  ///< why the shape has none, with OnError::skip; otherwise empty
};

/// Description of one shape, without its mesh.
struct ModelDescription {
  std::string sha256;                        ///< of the file; empty for a shape without file
  ShapeDiagnostics diagnostics;              ///< after the perturbations, in the file's units
  std::vector<FieldDescription> fields;      ///< as in the plan
  std::vector<Eigen::VectorXf> histograms;   ///< by signature; empty if it depends on other shapes
  std::vector<FeatureDescription> features;  ///< by planned descriptor; empty for those that have yet to learn
  std::string shape_key;                     ///< shape_key() in the cache; empty if unknown
  std::vector<std::size_t> chosen;           ///< choices of perturbations that choose
  std::vector<std::string> remarks = {};     ///< how perturbations fell short of their settings
  double area = 0;                           ///< area that was scaled to 1, in the file's units squared
  double noise = 0;                          ///< NoiseLevel::relative(), if the preparation estimates noise
  double pass_band = 0;                      ///< of the preparation's smoothing; 0 if not smoothed
  std::string picture;                       ///< model_picture(), if configured
  std::string view;                          ///< model_view(), if configured
};

/// Returns, by signature, why the shape has none: the first error of its field, its descriptor or its parts. Empty for
/// signatures without an error.
std::vector<std::string> signature_errors(const ModelDescription& model,
                                          const std::vector<SignatureConfiguration>& signatures,
                                          std::span<const PlannedField> plan);

/// Called for each field of a plan after its computation, with its index, the prepared shape, the samples and the
/// values.
using FieldObserver =
    std::function<void(std::size_t field, const PreparedShape&, const Samples&, const FieldValues& computed)>;

/// Prepared shape with its description so far.
struct PreparedModel {
  PreparedShape prepared;
  ModelDescription description;  ///< without fields and histograms

  /// Returns the diagnostics of the prepared shape, except for its scale; nothing if the preparation smoothed it.
  [[nodiscard]] std::optional<ShapeDiagnostics> known_diagnostics() const {
    return prepared.pass_band > 0 ? std::nullopt : std::optional(description.diagnostics);
  }
};

/// Prepares a shape. `known` are its diagnostics if they have been computed before. Throws InputError for an unusable
/// one.
PreparedModel prepare_model(PerturbedShape perturbed, const PreparationOptions& preparation,
                            const ShapeDiagnostics* known = nullptr);

/// Computes the planned fields and their histograms on a prepared shape, and adds them to its description. `source` is
/// that of the prepared shape; `parallel` distributes the samples over threads. Throws InputError for a field that the
/// shape does not have, or, with OnError::skip, records it (FieldDescription::error). Throws the errors of the
/// observer.
void describe_fields(PreparedModel& model, FieldSource& source, const std::vector<SignatureConfiguration>& signatures,
                     std::span<const PlannedField> plan, bool parallel, OnError on_error,
                     const FieldObserver& observe = {});

/// Prepares a shape and computes the planned fields and their histograms.
ModelDescription describe_shape(PerturbedShape perturbed, const PreparationOptions& preparation,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::span<const PlannedField> plan, bool parallel, const FieldObserver& observe = {});

/// Completes the description of a field: its range, the histograms that do not depend on other shapes, and its values
/// if the plan keeps them. Throws InputError if all values are missing.
void describe_field(const ScalarField& field, const PlannedField& planned,
                    const std::vector<SignatureConfiguration>& signatures, FieldDescription& kept,
                    std::vector<Eigen::VectorXf>& histograms);

/// Computes the features of a descriptor.
FeatureDescription describe_features(const DescriptorChoice& choice, const DescriptorInput& input,
                                     const LearntFeatures& learnt);

/// Returns the values kept by a description.
ScalarField kept_field(const FieldDescription& field);

/// Computes the histogram, over a range, of the values kept by a description.
Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options);

}  // namespace shapegauge
