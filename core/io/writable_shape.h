#pragma once

#include <filesystem>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Throws InputError where a file of this shape at `path` could not be read again: a coordinate that is not finite, a
/// triangle with a vertex that does not exist, a cloud's normals that are not finite or not one a point.
void require_writable(const std::filesystem::path& path, const Shape& shape);

/// Whether there are normals to write: those of a point cloud.
inline bool has_cloud_normals(const Shape& shape) { return is_cloud(shape) && shape.normals.rows() > 0; }

}  // namespace shapegauge
