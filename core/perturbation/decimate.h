#pragma once

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// How many faces a mesh may be simplified to.
inline constexpr Bounds decimate_faces_bounds{.low = 1, .high = 100'000'000};

/// The mesh with at most so many faces, by edge collapses in order of their quadric error (Garland and Heckbert 1997),
/// with OpenMesh. A collapse pulls one vertex onto a neighbour: every vertex of the result is one of the mesh.
/// Collapses that would turn a face over by more than about 80 degrees, make a sliver or change the topology are left
/// out; the result is closed where the mesh was, and every face keeps its orientation.
///
/// Vertices at the same place are taken as one and faces whose corners are not at three places are dropped. The ends of
/// edges with more than two faces, and of an edge of each band that cannot be oriented, stay; faces that a half-edge
/// structure cannot hold even so stay untouched. A mesh that has too many of these, or is simplified as far as it goes,
/// keeps more faces than asked for. Vertices that no face uses are dropped.
///
/// A mesh of no more faces is returned as it is. Throws InputError for a point cloud, a number of faces out of bounds,
/// a mesh without extent, and where not one edge can be collapsed.
Shape decimate(const Shape& shape, Eigen::Index faces);

}  // namespace shapegauge
