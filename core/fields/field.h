// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/registry.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

class OffsetSdfSolver;
class ProxySource;
struct OffsetSdfOutcomes;
struct Spectrum;

/// Shape for which several fields are computed, with the data they share. Keeps a reference to the shape.
class FieldSource {
 public:
  /// Refers to a shape, whose diagnostics may be passed if they are known, at this scale or another one.
  explicit FieldSource(const Shape& shape, std::optional<ShapeDiagnostics> known = {});
  ~FieldSource();
  FieldSource(const FieldSource&) = delete;
  FieldSource& operator=(const FieldSource&) = delete;
  FieldSource(FieldSource&&) = delete;
  FieldSource& operator=(FieldSource&&) = delete;

  [[nodiscard]] const Shape& shape() const { return *shape_; }

  /// Returns the solver, built on first use. Throws as its constructor does.
  const OffsetSdfSolver& offset_sdf_solver();

  /// Returns the automatic offset, chosen on first use. Throws as automatic_offset() does.
  const AutomaticOffset& automatic_offset();

  /// Returns the laplacian_spectrum() with that many eigenvalues, computed on first use. Throws as laplacian_spectrum()
  /// does.
  const Spectrum& spectrum(int eigenvalues);

  /// Returns the shape's surface proxy and the data computed on it, shared with descriptors.
  ProxySource& proxy() { return *proxy_; }

 private:
  const Shape* shape_;
  std::optional<ShapeDiagnostics> known_;
  std::unique_ptr<OffsetSdfSolver> offset_sdf_solver_;
  std::optional<AutomaticOffset> automatic_offset_;
  std::map<int, std::unique_ptr<Spectrum>> spectra_;  ///< by number of eigenvalues
  std::unique_ptr<ProxySource> proxy_;
};

/// Sampling sites of a field.
struct SamplePlan {
  SampleSite site = SampleSite::faces;
  Eigen::Index count = 0;  ///< number of surface samples

  auto operator<=>(const SamplePlan&) const = default;
};

/// Samples a shape according to the plan (sample_shape(), sample_surface()).
Samples take_samples(const Shape& shape, const SamplePlan& plan);

/// Number of samples by outcome. The key "total" is always present.
using FieldOutcomes = std::map<std::string, std::size_t>;

/// Returns the outcomes of an offset SDF by name.
FieldOutcomes field_outcomes(const OffsetSdfOutcomes& outcomes);

/// Returns a warning such as "3 of 200 samples missing" for each outcome that users should know about.
std::vector<std::string> outcome_warnings(const FieldOutcomes& outcomes);

/// Returns a warning if the weights of samples have no positive, finite sum: means and shares by area have no value.
std::optional<std::string> weights_warning(const Samples& samples);

/// Values of a field on one shape.
struct FieldValues {
  Eigen::VectorXd values;       ///< one per sample; NaN if missing
  Points normals = {};          ///< outward unit normals, one per sample, of fields that estimate them; otherwise empty
  FieldOutcomes outcomes = {};  ///< if a field returns none: "total" and "missing", counted from the values
  std::optional<double> offset = {};  ///< r as a fraction of the diagonal, if the field chose it for the shape
  double build_seconds =
      0;  ///< construction of spatial structures, including those shared with other fields of the shape
  double query_seconds = 0;  ///< queries for all samples; total time of a field that does not separate the two
};

/// Computes the values at the samples of a shape. `parallel` distributes the samples over the threads of the calling
/// TBB arena; values must not depend on it.
using FieldFunction = std::function<FieldValues(FieldSource&, const Samples&, bool parallel)>;

/// Physical dimension of a field's values: the power of the shape's scale that they are proportional to.
enum class FieldDimension { none = 0, length = 1, area = 2 };

/// Returns `length` to the power of the dimension: the factor of values if lengths change by the factor `length`.
double unit_of(FieldDimension dimension, double length);

/// Cache versions of algorithms by name; see docs/manual/cache.md.
using AlgorithmVersions = std::map<std::string, int>;

/// Computation of a field with given settings.
struct FieldComputation {
  AlgorithmVersions versions;  ///< of all algorithms that the values depend on, apart from the samples
  FieldDimension dimension = FieldDimension::length;  ///< of the values; comparisons of shapes undo the scale by it
  FieldFunction compute;
};

/// Type of field.
struct FieldType {
  std::string name;
  std::string description;  ///< one sentence
  /// Names, choices and descriptions must outlive the entry; they are not copied.
  std::vector<Parameter> parameters;
  /// Makes the computation for the given settings. Throws InputError if settings contradict each other.
  std::function<FieldComputation(const ParameterValues& values, const SamplePlan& samples)> make;
  bool is_thickness = false;  ///< the values are thicknesses, in the shape's units: a method of `sdf`
};

/// Returns the registry of field types: those of this folder (docs/developer/extending.md), followed by those added. An
/// entry must have a `make` function, and no parameters called type, at or bilateral.
Registry<FieldType>& field_types();

/// Returns the parameters of smoothing along the surface (bilateral_smoothing()), available for every field.
std::span<const Parameter> bilateral_parameters();

/// Settings of a field. Equal settings mean the same field.
struct FieldSettings {
  std::string type;  ///< a name of field_types()
  ParameterValues values;
  SamplePlan samples = {};
  std::optional<ParameterValues> smoothing = {};  ///< of bilateral_parameters(); not smoothed if absent

  bool operator==(const FieldSettings&) const = default;
};

/// Returns the default settings of a type, sampled at the faces. Throws InputError for a type that is not in
/// field_types().
FieldSettings field_settings(std::string_view type);

/// Scalar field: its settings and the function that computes its values.
struct Field {
  FieldSettings settings;
  AlgorithmVersions versions;
  FieldDimension dimension = FieldDimension::length;
  FieldFunction compute;
};

/// Makes the field with the given settings. Throws InputError for a type that is not in field_types(), for a setting
/// without a value, and for settings that contradict each other.
Field make_field(FieldSettings settings);

}  // namespace shapegauge
