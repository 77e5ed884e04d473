#pragma once

#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Normals by the offset surface.
struct OffsetNormals {
  Points normals;  ///< unit vectors, a row a sample; zero where missing
  OffsetSdfOutcomes outcomes;
};

/// Outward unit normals at samples of a shape, a mesh or a cloud: the direction from the sample to the closest point of
/// the outer offset surface, (q - p)/|q - p| (the paper, section "Normal estimation";
/// docs/reference/definitions.md#offset-sdf).
///
/// Outward is where the unbounded space is, whatever the orientation of triangles or the normals of a cloud say. An
/// offset above the noise and the gaps (automatic_offset) looks past both; one above the radius of a concavity looks
/// out of it. offset_sdf() has these normals beside the SDF; options and errors are its.
OffsetNormals offset_normals(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options);

}  // namespace shapegauge
