// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Returns the surface of a shape as a mesh without duplicate triangles. A point cloud becomes squares: one in the
/// tangent plane of each point, with four times the point's area (point_weights()). Squares of randomly spread points
/// cover 98 % of a smooth surface. The normals are those of the cloud or, without any, unsigned_point_normals().
/// Because areas are proportional to the points', means over the squares are means over the surface. Points without
/// area or normal have no square. Throws InputError for an unusable shape (require_usable()).
Shape surface_mesh(const Shape& shape);

}  // namespace shapegauge
