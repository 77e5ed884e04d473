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

/// Quantities of a shape that its perturbation and preparation determine: diagnostics, choices, scale, noise.
struct ShapeFacts {
  ShapeDiagnostics diagnostics;     ///< diagnostics of the perturbed shape, in the file's units
  std::vector<std::size_t> chosen;  ///< indices of the chosen lists of perturbation steps (PerturbedShape::chosen)
  std::vector<std::string> remarks = {};  ///< remarks on the perturbations (PerturbedShape::remarks)
  double area = 0;                        ///< area before the shape is scaled to area 1, in the file's units squared
  double noise = 0;                       ///< noise divided by edge length (NoiseLevel::relative()); 0 if not estimated
  double pass_band = 0;                   ///< pass band of the smoothing (taubin_smoothing()); 0 if not smoothed
};

/// Values of a field on one shape, as stored in the cache.
struct StoredField {
  Interval range;                ///< smallest and largest value of the field
  FieldOutcomes outcomes;        ///< numbers of samples by outcome of the field
  std::optional<double> offset;  ///< automatically chosen offset, a fraction of the diagonal; none for other fields
  double seconds = 0;            ///< run time of the computation of the field in seconds
  Eigen::VectorXd values;        ///< value at each sample, NaN if missing; in double precision for histograms
};

/// Feature vector of one shape: the output of a descriptor, or the histogram of a field.
struct FeatureDescription {
  Eigen::VectorXf features;  ///< feature vector; empty if not computed
  double seconds = 0;        ///< run time of the descriptor in seconds, without that of its fields
  std::string error = {};    ///< reason why the shape has no features, with OnError::skip; empty if it has them
};

SHAPEGAUGE_MEMBERS(ShapeDiagnostics, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v)
SHAPEGAUGE_MEMBERS(ShapeFacts, diagnostics, chosen, remarks, area, noise, pass_band)
SHAPEGAUGE_MEMBERS(Interval, low, high)
SHAPEGAUGE_MEMBERS(StoredField, range, outcomes, offset, seconds, values)
SHAPEGAUGE_MEMBERS(FeatureDescription, features, seconds, error)

/// Makes the cache entry of a field from its computed values at the samples. Throws InputError if all values are
/// missing.
StoredField stored_field(const Field& field, FieldValues computed, const Samples& samples);

/// Computes the features of a shape by a descriptor and measures the run time. `learnt` are the features learnt from
/// the data set; empty for a descriptor that does not learn.
FeatureDescription describe_features(const DescriptorChoice& choice, const DescriptorInput& input,
                                     const LearntFeatures& learnt);

/// Computes the results of one perturbed and prepared shape through the cache: each is found there, or computed and
/// stored. The shape is read and prepared only when a result is missing. Not thread-safe.
class CachedShape {
 public:
  /// `key` is the shape_key(). `read` reads and perturbs the shape. With `parallel`, samples are distributed over
  /// threads.
  CachedShape(std::string key, std::function<PerturbedShape()> read, const PreparationOptions& preparation,
              bool parallel, Cache& cache);

  /// Returns the shape_key().
  [[nodiscard]] const std::string& key() const { return key_; }

  /// Return results of the shape through the cache. Throw InputError for an unusable shape, and for a field or
  /// descriptor that the shape does not have.
  /// @{
  const ShapeFacts& facts();                                    ///< diagnostics, scale and noise
  const StoredField& field(const Field& field);                 ///< values of a field with their range and outcomes
  const Eigen::VectorXd& weights(const SamplePlan& plan);       ///< area represented by each sample of the plan
  ScalarField values(const Field& field);                       ///< values of a field with the weights of the samples
  FeatureDescription features(const DescriptorChoice& choice);  ///< features by a descriptor that does not learn
  /// Returns the picture (model_picture()) coloured by a field, as PNG bytes; `up` is the vertical direction.
  std::string picture(const Field& field, const PictureOptions& options, const Eigen::Vector3d& up);
  /// Returns the interactive view (model_view()) with these fields. Fields that the shape does not have (`has_field` is
  /// false) have no values in the view.
  std::string view(std::span<const Field> fields, const std::vector<bool>& has_field, const ShapeDrawing& drawing);
  /// @}

  /// Return the prepared shape, its samples and the values of a field, computed without the cache.
  /// @{
  const PreparedShape& prepared();
  const Samples& samples(SamplePlan plan);
  FieldValues compute(const Field& field);  ///< values of a field at its samples, with run times
                                            /// @}

 private:
  /// Prepared shape with the inputs of its fields.
  struct Opened {
    PreparedShape prepared;                      ///< shape after its preparation
    std::optional<FieldSource> source = {};      ///< intermediate results that fields share
    std::map<SamplePlan, Samples> samples = {};  ///< samples per plan, once requested
  };

  Opened& opened();  ///< reads and prepares the shape at the first call

  std::string key_;                                ///< shape_key()
  std::function<PerturbedShape()> read_;           ///< reads and perturbs the shape
  PreparationOptions preparation_;                 ///< options of the preparation
  bool parallel_;                                  ///< true to distribute samples over threads
  Cache* cache_;                                   ///< cache of the results; not owned, not null
  std::optional<ShapeFacts> facts_;                ///< result of facts(); absent until found or computed
  std::map<std::string, StoredField> fields_;      ///< results of field(), with field_key() as key
  std::map<SamplePlan, Eigen::VectorXd> weights_;  ///< results of weights(), per plan
  std::unique_ptr<Opened> opened_;                 ///< prepared shape; null until a result must be computed
};

}  // namespace shapegauge
