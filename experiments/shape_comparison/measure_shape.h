// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/members.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/shape_comparison/field_errors.h"
#include "shapegauge/experiments/signatures/describe_model.h"

namespace shapegauge {

/// Results of a comparison for one field on one shape.
struct FieldMeasurement {
  std::size_t samples = 0;
  std::size_t missing = 0;  ///< samples without a value
  double build_seconds = 0;
  double query_seconds = 0;
  std::optional<ValueErrors> errors;           ///< only with a reference to which the shapes are registered
  std::optional<NormalErrors> offset_normals;  ///< likewise, if the field estimates normals and the reference is a mesh
  std::optional<NormalErrors> own_normals;     ///< of the samples' own normals; together with offset_normals
};

/// Reference to which the other shapes are registered, as the cache has it.
struct ReferenceShape {
  std::string key;  ///< shape_key()
  Points vertices;  ///< after the perturbations
  Triangles triangles;
  std::vector<PlacedValues> values;  ///< per field
};

/// Ground truth of a reference, which it refers to.
struct GroundTruth {
  explicit GroundTruth(const ReferenceShape& of);

  const ReferenceShape* reference;
  double diagonal = 0;                 ///< of the reference's bounding box
  std::optional<TrueNormals> normals;  ///< if it is a mesh
};

/// Everything that a comparison measures on one shape.
struct MeasuredShape {
  std::string name = {};                 ///< in the comparison; not in the cache
  double read_seconds = 0;               ///< reading or generating the shape
  std::vector<FieldMeasurement> fields;  ///< per field
  ModelDescription description;
  std::optional<ReferenceShape> reference;  ///< if other shapes are compared with this one
};

/// Reads, perturbs and prepares the shape of that index, and computes the fields on it with all threads of the
/// calling TBB arena, through the cache. Run times from the cache are those of the run that computed the shape.
/// `truth` is that of the reference to compare with, if any; null for the reference itself. Throws InputError for an
/// unusable shape, and for a field that it does not have, and Interrupted between fields.
MeasuredShape measure_through_cache(const ShapeComparison& comparison, std::size_t index, std::span<const Field> fields,
                                    const GroundTruth* truth, const RunControl& control, Cache& cache);

SHAPEGAUGE_MEMBERS(ValueErrors, median, percentile_90, relative_median, relative_percentile_90)
SHAPEGAUGE_MEMBERS(NormalErrors, mean, median, percentile_90)
SHAPEGAUGE_MEMBERS(FieldMeasurement, samples, missing, build_seconds, query_seconds, errors, offset_normals,
                   own_normals)
SHAPEGAUGE_MEMBERS(PlacedValues, points, values, dimension)
SHAPEGAUGE_MEMBERS(ReferenceShape, key, vertices, triangles, values)
inline auto members(MeasuredShape& measured) {
  auto& [name, read_seconds, fields, description, reference] = measured;
  return std::tie(read_seconds, fields, description, reference);
}

}  // namespace shapegauge
