#pragma once

#include <Eigen/Core>
#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A shape that fields are computed of, one after the other, and what they share. Keeps a reference to the shape.
class FieldSource {
 public:
  explicit FieldSource(const Shape& shape) : shape_(&shape) {}

  [[nodiscard]] const Shape& shape() const { return *shape_; }

  /// Made when it is first asked for; throws what its constructor throws.
  const OffsetSdfSolver& offset_sdf_solver() {
    if (!offset_sdf_solver_) offset_sdf_solver_.emplace(*shape_);
    return *offset_sdf_solver_;
  }

 private:
  const Shape* shape_;
  std::optional<OffsetSdfSolver> offset_sdf_solver_;
};

/// Where a field takes its samples.
struct SamplePlan {
  SampleSite site = SampleSite::faces;
  Eigen::Index count = 0;  ///< surface: how many

  auto operator<=>(const SamplePlan&) const = default;
};

/// The setting "at" of fields: "faces" (default), "vertices" or {"surface": number of samples}.
SamplePlan sample_plan_of(const nlohmann::json& settings);

/// The setting that the plan was read from.
nlohmann::json to_json(const SamplePlan& plan);

/// The samples of a shape that the plan asks for (sample_shape, sample_surface_of).
Samples take_samples(const Shape& shape, const SamplePlan& plan);

/// How many samples had which outcome, by the outcome's name. "total" is always there; "undecided" and "missing" are
/// the outcomes that a run warns about.
using FieldOutcomes = std::map<std::string, std::size_t>;

/// The values of a field on one shape.
struct FieldValues {
  Eigen::VectorXd values;  ///< one a sample; NaN where there is none
  Points normals = {};     ///< of fields that estimate them: outward unit normals, one a sample; else empty
  FieldOutcomes outcomes;
  std::optional<double> offset;  ///< r as a fraction of the diagonal, where the field chose it for the shape
  double build_seconds = 0;      ///< spatial structures, those shared with other fields of the shape included
  double query_seconds = 0;      ///< all samples
};

/// A scalar field that a configuration asks for: where its samples are and how its values are computed.
struct Field {
  nlohmann::json settings;  ///< type and all settings, defaults filled in; fields with equal settings are one field
  nlohmann::json versions;  ///< of the algorithms that the values depend on besides the samples, by name
  SamplePlan samples;
  /// The values at the samples of a shape; parallel: spread the samples over the threads of the calling TBB arena.
  std::function<FieldValues(FieldSource&, const Samples&, bool parallel)> compute;
};

/// What a run did with a field, over all models used.
struct FieldReport {
  nlohmann::json settings;
  FieldOutcomes outcomes;  ///< sums
  double seconds = 0;      ///< sum over the models, whatever ran at the same time
};

/// A kind of field that configurations can name.
struct FieldType {
  std::string_view name;
  /// The field of the given settings, which the schema has accepted. Throws InputError where they contradict each
  /// other.
  Field (*make)(const nlohmann::json& settings);
};

/// All kinds of fields. A new one is one file in this folder, one line in field_registry.cpp, and the description of
/// its settings in configs/experiment.schema.json.
std::span<const FieldType> field_types();

/// The field that the settings describe, by their "type". Throws InputError for a type that is not in field_types().
Field make_field(const nlohmann::json& settings);

}  // namespace shapegauge
