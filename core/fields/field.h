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
  /// Refers to a shape. Pass its diagnose() result, if known, to skip computing it for automatic_offset(); only
  /// relative lengths are used, so the diagnostics may be those of the shape at another scale.
  explicit FieldSource(const Shape& shape, std::optional<ShapeDiagnostics> known = {});
  ~FieldSource();
  FieldSource(const FieldSource&) = delete;
  FieldSource& operator=(const FieldSource&) = delete;
  FieldSource(FieldSource&&) = delete;
  FieldSource& operator=(FieldSource&&) = delete;

  [[nodiscard]] const Shape& shape() const { return *shape_; }

  /// Returns the solver of the shape's offset SDF, built on first use. Throws as the solver's constructor does.
  const OffsetSdfSolver& offset_sdf_solver();

  /// Returns the automatic offset of the shape, chosen on first use. Throws as automatic_offset() does.
  const AutomaticOffset& automatic_offset();

  /// Returns the laplacian_spectrum() of the mesh with `eigenvalues` eigenvalues, computed on first use. Throws as
  /// laplacian_spectrum() does.
  const Spectrum& spectrum(int eigenvalues);

  /// Returns the shape's surface proxy and the data computed on it, shared with descriptors.
  ProxySource& proxy() { return *proxy_; }

 private:
  const Shape* shape_;
  std::optional<ShapeDiagnostics> known_;  ///< diagnostics passed to the constructor
  std::unique_ptr<OffsetSdfSolver> offset_sdf_solver_;
  std::optional<AutomaticOffset> automatic_offset_;
  std::map<int, std::unique_ptr<Spectrum>> spectra_;  ///< spectra by requested number of eigenvalues
  std::unique_ptr<ProxySource> proxy_;
};

/// Where a field is sampled on a shape: at each face, at each vertex, or at a number of points of the surface.
struct SamplePlan {
  SampleSite site = SampleSite::faces;  ///< faces, vertices or points of the surface
  Eigen::Index count = 0;               ///< number of points of the surface; unused for faces and vertices

  auto operator<=>(const SamplePlan&) const = default;  // NOLINT(modernize-use-nullptr): reported for what is generated
};

/// Samples a shape according to the plan (sample_shape(), sample_surface()).
Samples take_samples(const Shape& shape, const SamplePlan& plan);

/// Number of samples for each outcome of a field's computation, by name, such as "missing". The key "total" is always
/// present.
using FieldOutcomes = std::map<std::string, std::size_t>;

/// Converts the sample counts of an offset SDF to counts by name of outcome.
FieldOutcomes field_outcomes(const OffsetSdfOutcomes& outcomes);

/// Returns a warning such as "3 of 200 samples undecided" for each problem that occurred: samples that are missing,
/// undecided, two-sided (outside on both sides) or computed with an enlarged offset.
std::vector<std::string> outcome_warnings(const FieldOutcomes& outcomes);

/// Returns a warning if the weights of samples have no positive, finite sum: area-weighted means and fractions
/// are then undefined.
std::optional<std::string> weights_warning(const Samples& samples);

/// Values of a field at the samples of one shape, with sample counts and run times.
struct FieldValues {
  Eigen::VectorXd values;       ///< value at each sample; NaN if missing
  Points normals = {};          ///< outward unit normal at each sample if the field estimates normals; otherwise empty
  FieldOutcomes outcomes = {};  ///< sample counts by outcome; default: "total" and "missing", from the values
  /// Automatically chosen offset, in bounding-box diagonals; absent if none was chosen.
  std::optional<double> offset = {};
  double build_seconds =
      0;  ///< time to build search structures of the shape, even if other fields share them; 0 if not measured
  double query_seconds = 0;  ///< time of all queries; total time if the field does not separate building and queries
};

/// Function that computes the values of a field at samples of a shape. `parallel` distributes the samples over the
/// threads of the calling TBB arena; values must not depend on it.
using FieldFunction = std::function<FieldValues(FieldSource&, const Samples&, bool parallel)>;

/// Physical dimension of a field's values: the power of the shape's scale that they are proportional to.
enum class FieldDimension { none = 0, length = 1, area = 2 };

/// Returns the factor by which values of a dimension change if a shape is scaled by the factor `length`: `length` to
/// the power 0, 1 or 2.
double unit_of(FieldDimension dimension, double length);

/// Cache versions of algorithms by name; see docs/manual/cache.md.
using AlgorithmVersions = std::map<std::string, int>;

/// Function that computes a field with given settings, with the versions and physical dimension of its values.
struct FieldComputation {
  AlgorithmVersions versions;  ///< versions of all algorithms that the values depend on, except sampling
  FieldDimension dimension = FieldDimension::length;  ///< physical dimension of the values, to undo scaling of shapes
  FieldFunction compute;                              ///< computes the values at samples of a shape
};

/// Entry of field_types(): a kind of scalar field on shapes, its parameters and the function that makes it.
struct FieldType {
  std::string name;         ///< name in configurations, such as "offset_sdf"
  std::string description;  ///< what the field measures, in one sentence, for listings and help
  /// Parameters of the type. Their names, choices and descriptions are not copied and must outlive the entry.
  std::vector<Parameter> parameters;
  /// Returns the computation of the field for given settings. Throws InputError if settings contradict each other.
  std::function<FieldComputation(const ParameterValues& values, const SamplePlan& samples)> make;
  bool is_thickness = false;  ///< true if values are thicknesses in the shape's units; such types are methods of `sdf`
};

/// Returns the registry of field types: the built-in ones, followed by added ones (docs/developer/extending.md). An
/// entry must have a `make` function, and no parameters called type, at or bilateral.
Registry<FieldType>& field_types();

/// Returns the parameters of smoothing along the surface (bilateral_smoothing()), available for every field.
std::span<const Parameter> bilateral_parameters();

/// Settings of a field: type, parameter values, sampling and smoothing. Equal settings mean the same field.
struct FieldSettings {
  std::string type;                               ///< name of the type in field_types()
  ParameterValues values;                         ///< values of the parameters of the type
  SamplePlan samples = {};                        ///< where the field is sampled
  std::optional<ParameterValues> smoothing = {};  ///< values of bilateral_parameters(); absent: no smoothing

  bool operator==(const FieldSettings&) const = default;
};

/// Returns the default settings of a type, sampled at the faces. Throws InputError for a type that is not in
/// field_types().
FieldSettings field_settings(std::string_view type);

/// Scalar field: its settings and the function that computes its values.
struct Field {
  FieldSettings settings;      ///< settings that the field was made from
  AlgorithmVersions versions;  ///< versions of all algorithms that the values depend on, except sampling
  FieldDimension dimension = FieldDimension::length;  ///< physical dimension of the values, to undo scaling of shapes
  FieldFunction compute;  ///< computes the values at samples of a shape, smoothed if the settings say so
};

/// Makes a field from its settings. Throws InputError for a type that is not in field_types(), for a setting
/// without a value, and for settings that contradict each other.
Field make_field(FieldSettings settings);

}  // namespace shapegauge
