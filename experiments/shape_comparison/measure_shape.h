#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// Reference to which the other shapes are registered.
struct ReferenceShape {
  std::string key;                     ///< shape_key()
  Shape shape;                         ///< after the perturbations: vertices and triangles
  double diagonal = 0;                 ///< of the shape's bounding box
  std::optional<TrueNormals> normals;  ///< if it is a mesh
  std::vector<PlacedValues> values;    ///< by field
};

/// Makes a reference without values.
ReferenceShape make_reference(std::string key, Shape shape);

/// Everything that a comparison measures on one shape.
struct MeasuredShape {
  double read_seconds = 0;               ///< reading or generating the shape
  std::vector<FieldMeasurement> fields;  ///< by field
  ModelDescription description;
  std::optional<ReferenceShape> reference;  ///< if other shapes are compared with this one
};

/// Reads, perturbs and prepares the shape of that index, and computes the planned fields on it with all threads of the
/// calling TBB arena, through the cache. Run times from the cache are those of the run that computed the shape.
/// `reference` is the shape to compare with, if any; null for the reference itself. Throws as describe_shape() does,
/// and Interrupted between fields.
MeasuredShape measure_through_cache(const ShapeComparison& comparison, std::size_t index,
                                    std::span<const PlannedField> plan, const ReferenceShape* reference,
                                    const RunControl& control, Cache& cache);

}  // namespace shapegauge
