// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Valid range of the maximum number of faces of decimate().
inline constexpr Bounds decimate_faces_bounds{.low = 1, .high = 100'000'000};

/// Simplifies a mesh to at most `faces` faces by edge collapses in order of quadric error (Garland and Heckbert 1997),
/// with OpenMesh. A collapse pulls one vertex onto a neighbour: every vertex of the result is a vertex of the input.
/// Collapses that would rotate a face by more than about 80 degrees, create a sliver or change the topology are
/// rejected. A closed mesh stays closed, and faces keep their orientation.
///
/// Coincident vertices are welded; faces with fewer than three distinct corners and unused vertices are dropped. The
/// ends of edges with more than two faces and, for each non-orientable band, the ends of one edge are fixed. Faces that
/// a half-edge structure still cannot represent stay unchanged. The result has more faces than requested if too many
/// vertices are fixed or no collapse is left.
///
/// Returns a mesh with at most `faces` faces unchanged. Throws InputError for a point cloud, a number of faces out of
/// bounds, a mesh without extent, and if no edge can be collapsed.
Shape decimate(const Shape& shape, Eigen::Index faces);

}  // namespace shapegauge
