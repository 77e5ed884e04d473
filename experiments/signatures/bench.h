// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/members.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"
#include "shapegauge/experiments/signatures/model_view.h"

namespace shapegauge {

/// Findings of the perturbations and the preparation of a shape.
struct ShapeFacts {
  ShapeDiagnostics diagnostics;           ///< after the perturbations, in the file's units
  std::vector<std::size_t> chosen;        ///< choices of perturbations that choose
  std::vector<std::string> remarks = {};  ///< how perturbations fell short of their settings
  double area = 0;                        ///< area that was scaled to 1, in the file's units squared
  double noise = 0;                       ///< NoiseLevel::relative(), if the preparation estimates noise
  double pass_band = 0;                   ///< of the preparation's smoothing; 0 if not smoothed
};

/// Values of a field on one shape.
struct StoredField {
  Interval range;
  FieldOutcomes outcomes;
  std::optional<double> offset;  ///< if the field chose one
  double seconds = 0;
  Eigen::VectorXd values;  ///< in double precision, as histograms need them
};

/// Features of a descriptor of one shape.
struct FeatureDescription {
  Eigen::VectorXf features;
  double seconds = 0;      ///< without its fields
  std::string error = {};  ///< why the shape has none, with OnError::skip; otherwise empty
};

SHAPEGAUGE_MEMBERS(ShapeDiagnostics, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v)
SHAPEGAUGE_MEMBERS(ShapeFacts, diagnostics, chosen, remarks, area, noise, pass_band)
SHAPEGAUGE_MEMBERS(Interval, low, high)
SHAPEGAUGE_MEMBERS(StoredField, range, outcomes, offset, seconds, values)
SHAPEGAUGE_MEMBERS(FeatureDescription, features, seconds, error)

/// Makes the cache entry of computed values. Throws InputError if all values are missing.
StoredField stored_field(const Field& field, FieldValues computed, const Samples& samples);

/// Computes the features of a descriptor.
FeatureDescription describe_features(const DescriptorChoice& choice, const DescriptorInput& input,
                                     const LearntFeatures& learnt);

/// A shape with its perturbations and preparation, and the results that are computed on it. Each result is found in the
/// cache, or computed and stored. The shape is read and prepared when a result is missing. Not thread-safe.
class Bench {
 public:
  /// `key` is the shape_key(); `read` returns the perturbed shape; `parallel` distributes samples over threads.
  Bench(std::string key, std::function<PerturbedShape()> read, const PreparationOptions& preparation, bool parallel,
        Cache& cache);

  [[nodiscard]] const std::string& key() const { return key_; }

  /// Results. Throw InputError for an unusable shape, and for a field or descriptor that the shape does not have.
  /// @{
  const ShapeFacts& facts();
  const StoredField& field(const Field& field);
  const Eigen::VectorXd& weights(const SamplePlan& plan);  ///< of samples
  ScalarField values(const Field& field);
  FeatureDescription features(const DescriptorChoice& choice);  ///< of a descriptor that does not learn
  std::string picture(const Field& field, const PictureOptions& options, const Eigen::Vector3d& up);
  /// Returns the view with these fields, of which those that the shape does not have are missing everywhere.
  std::string view(std::span<const Field> fields, const std::vector<bool>& has_field, const ShapeDrawing& drawing);
  /// @}

  /// The prepared shape and what is computed on it without the cache.
  /// @{
  const PreparedShape& prepared();
  const Samples& samples(SamplePlan plan);
  FieldValues compute(const Field& field);
  /// @}

 private:
  struct Opened {
    PreparedShape prepared;
    std::optional<FieldSource> source = {};
    std::map<SamplePlan, Samples> samples = {};
  };

  Opened& opened();

  std::string key_;
  std::function<PerturbedShape()> read_;
  PreparationOptions preparation_;
  bool parallel_;
  Cache* cache_;
  std::optional<ShapeFacts> facts_;
  std::map<std::string, StoredField> fields_;  ///< by key
  std::map<SamplePlan, Eigen::VectorXd> weights_;
  std::unique_ptr<Opened> opened_;
};

}  // namespace shapegauge
