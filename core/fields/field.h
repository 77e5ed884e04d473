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
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

class OffsetSdfSolver;

/// A shape that fields are computed of, one after the other, and what they share. Keeps a reference to the shape.
class FieldSource {
 public:
  explicit FieldSource(const Shape& shape);
  ~FieldSource();
  FieldSource(const FieldSource&) = delete;
  FieldSource& operator=(const FieldSource&) = delete;
  FieldSource(FieldSource&&) = delete;
  FieldSource& operator=(FieldSource&&) = delete;

  [[nodiscard]] const Shape& shape() const { return *shape_; }

  /// Built when it is first asked for; throws what its constructor throws.
  const OffsetSdfSolver& offset_sdf_solver();

  /// laplacian_spectrum() of so many eigenvalues, computed when they are first asked for; throws what that throws.
  const Spectrum& spectrum(int eigenvalues);

  /// The shape's surface proxy and what is computed on it; shared with descriptors.
  ProxySource& proxy() { return proxy_; }

 private:
  const Shape* shape_;
  std::unique_ptr<OffsetSdfSolver> offset_sdf_solver_;
  std::map<int, std::unique_ptr<Spectrum>> spectra_;  ///< by number of eigenvalues
  ProxySource proxy_;
};

/// Where a field takes its samples.
struct SamplePlan {
  SampleSite site = SampleSite::faces;
  Eigen::Index count = 0;  ///< surface: how many

  auto operator<=>(const SamplePlan&) const = default;
};

/// The samples of a shape that the plan asks for (sample_shape, sample_surface_of).
Samples take_samples(const Shape& shape, const SamplePlan& plan);

/// Number of samples by outcome. "total" is always there.
using FieldOutcomes = std::map<std::string, std::size_t>;

/// A sentence, "3 of 200 samples missing", for each of the outcomes that users are to be warned of.
std::vector<std::string> outcome_warnings(const FieldOutcomes& outcomes);

/// The values of a field on one shape.
struct FieldValues {
  Eigen::VectorXd values;             ///< one a sample; NaN where there is none
  Points normals = {};                ///< of fields that estimate them: outward unit normals, one a sample; else empty
  FieldOutcomes outcomes = {};        ///< where a field gives none: "total" and "missing", counted from the values
  std::optional<double> offset = {};  ///< r as a fraction of the diagonal, where the field chose it for the shape
  double build_seconds = 0;           ///< spatial structures, those shared with other fields of the shape included
  double query_seconds = 0;           ///< all samples; of a field that does not tell them apart, everything
};

/// Computes the values at the samples of a shape. parallel: spread the samples over the threads of the calling TBB
/// arena; the values may not depend on it.
using FieldFunction = std::function<FieldValues(FieldSource&, const Samples&, bool parallel)>;

/// Physical dimension of a field's values: they change with this power of the shape's scale.
enum class FieldDimension { none = 0, length = 1, area = 2 };

/// `length` to the power of the dimension: the factor of values where lengths change by the factor `length`.
double unit_of(FieldDimension dimension, double length);

/// Versions of algorithms by name. A version is raised with every change of a value: values that a cache holds of other
/// versions are not used.
using AlgorithmVersions = std::map<std::string, int>;

/// How a field of given settings is computed.
struct FieldComputation {
  AlgorithmVersions versions;                         ///< of what the values depend on besides the samples
  FieldDimension dimension = FieldDimension::length;  ///< of the values; comparisons of shapes undo the scale by it
  FieldFunction compute;
};

/// A type of field.
struct FieldType {
  std::string name;
  std::string description;  ///< one sentence
  /// Names, choices and descriptions are referred to, not copied.
  std::vector<Parameter> parameters;
  /// Throws InputError where settings contradict each other.
  std::function<FieldComputation(const ParameterValues& values, const SamplePlan& samples)> make;
};

/// All types of fields: those of this folder (docs/developer/extending.md), then those that were added. An entry has a
/// `make`, and no parameters called type, at or bilateral.
Registry<FieldType>& field_types();

/// The settings by which any field is smoothed along the surface (bilateral_smoothing()).
std::span<const Parameter> bilateral_parameters();

/// The settings of a field; those with equal settings are one field.
struct FieldSettings {
  std::string type;  ///< a name of field_types()
  ParameterValues values;
  SamplePlan samples = {};
  std::optional<ParameterValues> smoothing = {};  ///< of bilateral_parameters(); none: as computed

  bool operator==(const FieldSettings&) const = default;
};

/// The settings of a type with all defaults, at the faces. Throws InputError for a type that is not in field_types().
FieldSettings field_settings(std::string_view type);

/// A scalar field: what it is and how its values are computed.
struct Field {
  FieldSettings settings;
  AlgorithmVersions versions;
  FieldDimension dimension = FieldDimension::length;
  FieldFunction compute;
};

/// The field of the settings. Throws InputError for a type that is not in field_types(), for a setting without a value,
/// and for settings that contradict each other.
Field make_field(FieldSettings settings);

}  // namespace shapegauge
