#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/fields.h"
#include "shapegauge/experiments/configuration/perturbations.h"

namespace shapegauge {

/// A field to compute on every shape, and the signatures that use it.
struct PlannedField {
  Field field;
  std::vector<std::size_t> signatures;  ///< indices of the signatures that are histograms of it
  bool keep_values = false;             ///< a histogram over the whole data set's range has to wait for all shapes
};

/// The distinct fields of the signatures, in order of first use: fields of equal settings are computed once.
std::vector<PlannedField> plan_fields(const std::vector<SignatureConfiguration>& signatures);

/// Whether it is the field that colours the models in the report.
bool is_pictured(const PlannedField& planned, const ReportConfiguration& report);

/// What one shape gave for one field.
struct FieldDescription {
  Interval range;           ///< of the values
  Eigen::VectorXf values;   ///< kept where the plan says so, else empty; single precision, as there is one a sample and
  Eigen::VectorXf weights;  ///< a data set has millions
  FieldOutcomes outcomes;
  std::optional<double> offset;  ///< where the field chose one
  double seconds = 0;
};

/// What is kept of one shape; its mesh is not.
struct ModelDescription {
  std::string sha256;                       ///< of the file; empty where a shape has none
  ShapeDiagnostics diagnostics;             ///< after the perturbations, in the file's units
  std::vector<FieldDescription> fields;     ///< as in the plan
  std::vector<Eigen::VectorXf> histograms;  ///< by signature; empty where it cannot be computed from one shape alone
  std::vector<std::size_t> chosen;          ///< what perturbations that choose have chosen
  double area = 0;                          ///< that was scaled to 1, in the file's units, squared
  double noise = 0;                         ///< NoiseLevel::relative(), where the preparation looks for noise
  double pass_band = 0;                     ///< of the preparation's smoothing; 0: none
  std::string picture;                      ///< model_picture(), where the configuration wants one
};

/// Called for each field of a plan once it is computed, with its index, the prepared shape, the samples and the values.
using FieldObserver =
    std::function<void(std::size_t field, const PreparedShape&, const Samples&, const FieldValues& computed)>;

/// Prepares a shape and computes the planned fields and their histograms. parallel: spread the samples over threads.
/// Throws InputError or std::invalid_argument where the shape is of no use, and what the observer throws.
ModelDescription describe_shape(PerturbedShape perturbed, const PreparationOptions& preparation,
                                const std::vector<SignatureConfiguration>& signatures,
                                std::span<const PlannedField> plan, bool parallel, const FieldObserver& observe = {});

/// Completes the description of a field: its range, the histograms that need no other shape, and its values where the
/// plan keeps them. Throws InputError where no sample has a value.
void describe_field(const ScalarField& field, const PlannedField& planned,
                    const std::vector<SignatureConfiguration>& signatures, FieldDescription& kept,
                    std::vector<Eigen::VectorXf>& histograms);

/// The histogram, over a range, of the values that a description keeps.
Eigen::VectorXf kept_histogram(const FieldDescription& field, const Interval& range, const HistogramOptions& options);

}  // namespace shapegauge
