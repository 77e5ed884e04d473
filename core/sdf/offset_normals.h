#pragma once

#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Normals estimated from the offset surface.
struct OffsetNormals {
  Points normals;  ///< unit vectors, one row per sample; zero if missing
  OffsetSdfOutcomes outcomes;
};

/// Estimates outward unit normals at samples of a mesh or cloud as (q - p)/|q - p|, where q is the point of the outer
/// offset surface closest to the sample p (the paper, section "Normal estimation";
/// docs/reference/definitions.md#offset-sdf).
///
/// Outward means towards the unbounded exterior, independent of the orientation of triangles and of a cloud's normals.
/// An offset above noise and gaps (automatic_offset()) is robust to both. With an offset above the radius of a
/// concavity, normals point out of the concavity. offset_sdf() returns the same normals together with the SDF, and has
/// the same options and errors.
OffsetNormals offset_normals(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options);

}  // namespace shapegauge
