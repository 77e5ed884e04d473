#pragma once

#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The shape in the bytes of a PLY file, ASCII or binary of either byte order: x, y, z of the element `vertex` and
/// `vertex_indices` (or `vertex_index`) of the element `face`; everything else is passed over. Polygons become fans;
/// faces of fewer than three vertices leave no triangle. Without faces it is a point cloud, whose normals are nx, ny,
/// nz of the vertices, where they have them.
///
/// `name` stands in front of messages. Throws InputError, with the line or the element: truncated, index out of range,
/// coordinate that is not finite, triangle strips.
Shape read_ply(const std::string& bytes, const std::string& name);

/// Throws InputError where the bytes do not begin with the header of a PLY file that has vertices.
void check_ply_header(const std::string& bytes, const std::string& name);

}  // namespace shapegauge
