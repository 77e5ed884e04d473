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

/// A field to compute on every shape, and the signatures that use it.
struct PlannedField {
  Field field;
  std::vector<std::size_t> signatures;  ///< indices of the signatures that are histograms of it
  bool keep_values = false;             ///< what depends on the whole data set has to wait for all shapes
};

/// A descriptor to compute on every shape, and its fields in the plan.
struct PlannedDescriptor {
  std::size_t signature = 0;        ///< index of the signature that it is
  std::vector<std::size_t> fields;  ///< indices in the plan of fields
  bool learns = false;              ///< it must see all shapes first
};

/// The distinct fields of the signatures, in order of first use: fields of equal settings are computed once.
std::vector<PlannedField> plan_fields(const std::vector<SignatureConfiguration>& signatures);

/// The signatures that are descriptors, in order, with their fields in plan_fields().
std::vector<PlannedDescriptor> plan_descriptors(const std::vector<SignatureConfiguration>& signatures,
                                                std::span<const PlannedField> plan);

/// Whether it is the field that colours the models in the report.
bool is_pictured(const PlannedField& planned, const Configuration& configuration);

/// The most fields in the view of a model.
inline constexpr std::size_t most_viewed_fields = 6;

/// The indices of the fields that the views of the models show: the one that colours their pictures, then those that
/// signatures are histograms of. None where the configuration wants no views.
std::vector<std::size_t> viewed_fields(std::span<const PlannedField> plan, const Configuration& configuration);

/// What one shape gave for one field.
struct FieldDescription {
  Interval range;           ///< of the values
  Eigen::VectorXf values;   ///< kept where the plan says so, else empty; single precision, as there is one a sample and
  Eigen::VectorXf weights;  ///< a data set has millions
  FieldOutcomes outcomes;
  std::optional<double> offset;  ///< where the field chose one
  double seconds = 0;
};

/// What one shape gave for one descriptor.
struct FeatureDescription {
  Eigen::VectorXf features;
  double seconds = 0;  ///< without its fields
};

/// What is kept of one shape; its mesh is not.
struct ModelDescription {
  std::string sha256;                        ///< of the file; empty where a shape has none
  ShapeDiagnostics diagnostics;              ///< after the perturbations, in the file's units
  std::vector<FieldDescription> fields;      ///< as in the plan
  std::vector<Eigen::VectorXf> histograms;   ///< by signature; empty where it cannot be computed from one shape alone
  std::vector<FeatureDescription> features;  ///< by planned descriptor; of those that learn empty until they have
  std::string shape_key;                     ///< shape_key() in the cache; empty where there is none
  std::vector<std::size_t> chosen;           ///< what perturbations that choose have chosen
  double area = 0;                           ///< that was scaled to 1, in the file's units, squared
  double noise = 0;                          ///< NoiseLevel::relative(), where the preparation looks for noise
  double pass_band = 0;                      ///< of the preparation's smoothing; 0: none
  std::string picture;                       ///< model_picture(), where the configuration wants one
  std::string view;                          ///< model_view(), where the configuration wants one
};

/// Called for each field of a plan once it is computed, with its index, the prepared shape, the samples and the values.
using FieldObserver =
    std::function<void(std::size_t field, const PreparedShape&, const Samples&, const FieldValues& computed)>;

/// A shape that is ready to be measured, and what is known of it so far.
struct PreparedModel {
  PreparedShape prepared;
  ModelDescription description;  ///< without fields and histograms
};

/// Prepares a shape. Throws InputError where it is of no use.
PreparedModel prepare_model(PerturbedShape perturbed, const PreparationOptions& preparation);

/// Computes the planned fields and their histograms on a prepared shape, and adds them to its description. source: of
/// the prepared shape. parallel: spread the samples over threads. Throws InputError where the shape is of no use, and
/// what the observer throws.
void describe_fields(PreparedModel& model, FieldSource& source, const std::vector<SignatureConfiguration>& signatures,
                     std::span<const PlannedField> plan, bool parallel, const FieldObserver& observe = {});

/// Prepares a shape and computes the planned fields and their histograms: the two functions above.
ModelDescription describe_shape(PerturbedShape perturbed, const PreparationOptions& preparation,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::span<const PlannedField> plan, bool parallel, const FieldObserver& observe = {});

/// Completes the description of a field: its range, the histograms that need no other shape, and its values where the
/// plan keeps them. Throws InputError where no sample has a value.
void describe_field(const ScalarField& field, const PlannedField& planned,
                    const std::vector<SignatureConfiguration>& signatures, FieldDescription& kept,
                    std::vector<Eigen::VectorXf>& histograms);

/// The features of a descriptor.
FeatureDescription describe_features(const DescriptorChoice& choice, const DescriptorInput& input,
                                     const LearntFeatures& learnt);

/// The values that a description keeps.
ScalarField kept_field(const FieldDescription& field);

/// The histogram, over a range, of the values that a description keeps.
Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options);

}  // namespace shapegauge
