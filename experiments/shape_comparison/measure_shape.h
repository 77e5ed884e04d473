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

/// Measurements of one field on one shape of a comparison: numbers of samples, run times and errors.
struct FieldMeasurement {
  std::size_t samples = 0;                     ///< number of samples, with and without a value
  std::size_t missing = 0;                     ///< number of samples without a value
  double build_seconds = 0;                    ///< time to build search structures, in seconds
  double query_seconds = 0;                    ///< time to compute the values at the samples, in seconds
  std::optional<ValueErrors> errors;           ///< errors of the values; absent without a registered reference
  std::optional<NormalErrors> offset_normals;  ///< errors of normals that the field estimates; absent if it has none
  std::optional<NormalErrors> shape_normals;   ///< errors of the shape's own normals; absent if offset_normals is
};

/// Reference of a comparison as stored in the cache: geometry and field values with which other shapes are compared.
struct ReferenceShape {
  std::string key;                    ///< cache key of the shape (shape_key())
  Points vertices;                    ///< vertex positions after the perturbations
  Triangles triangles;                ///< vertex indices of the triangles; none for a point cloud
  std::vector<LocatedValues> values;  ///< per field of the comparison: values at the samples
};

/// Ground truth of a comparison, computed from a reference shape, which must outlive it.
struct GroundTruth {
  explicit GroundTruth(const ReferenceShape& of);  ///< ground truth of the reference shape `of`

  const ReferenceShape* reference;     ///< reference shape; not owned, not null
  double diagonal = 0;                 ///< diagonal of the reference's bounding box
  std::optional<TrueNormals> normals;  ///< triangle normals; absent if the reference is a point cloud
};

/// Everything that a comparison measures on one shape.
struct MeasuredShape {
  std::string name = {};                    ///< name of the shape in the comparison; not stored in the cache
  double read_seconds = 0;                  ///< time to read or generate the shape, in seconds
  std::vector<FieldMeasurement> fields;     ///< one measurement per field of the comparison
  ModelDescription description;             ///< diagnostics, histograms and outcomes of the fields
  std::optional<ReferenceShape> reference;  ///< this shape as the reference; absent for other shapes
};

/// Measures the shape at `index` of the comparison, through the cache: reads, perturbs and prepares it, and computes
/// the fields with all threads of the calling TBB arena. Run times from the cache are those of the run that computed
/// the shape. `truth` is the ground truth of the reference; null for the reference itself and without a reference.
/// Throws InputError for an unusable shape and for a field that cannot be computed on it, and Interrupted between
/// fields.
MeasuredShape measure_through_cache(const ShapeComparison& comparison, std::size_t index, std::span<const Field> fields,
                                    const GroundTruth* truth, const RunControl& control, Cache& cache);

SHAPEGAUGE_MEMBERS(ValueErrors, median, percentile_90, relative_median, relative_percentile_90)
SHAPEGAUGE_MEMBERS(NormalErrors, mean, median, percentile_90)
SHAPEGAUGE_MEMBERS(FieldMeasurement, samples, missing, build_seconds, query_seconds, errors, offset_normals,
                   shape_normals)
SHAPEGAUGE_MEMBERS(LocatedValues, points, values, dimension)
SHAPEGAUGE_MEMBERS(ReferenceShape, key, vertices, triangles, values)
/// Returns references to the members that the cache stores, for their encoding (codec.h).
inline auto members(MeasuredShape& measured) {
  auto& [name, read_seconds, fields, description, reference] = measured;
  return std::tie(read_seconds, fields, description, reference);
}

}  // namespace shapegauge
