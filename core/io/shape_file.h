#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// To be raised with every change of the shape that a sound file is read as: what a cache holds of earlier versions is
/// then computed anew.
inline constexpr int shape_reading_version = 1;

/// Reads a shape from an OFF, OBJ, PLY or STL file, or a point cloud from any of these but STL without faces or from
/// lines of numbers (XYZ, PWN, PTS, TXT), by the name's extension and, failing that, by the first bytes.
/// Polygons become fans of triangles, in the file's order. Every vertex and every face of the file is kept: duplicates,
/// degenerate and non-manifold faces survive. STL vertices with equal coordinates are merged, as the format has no
/// indices. Throws InputError: absent, unreadable or truncated file, index out of range, coordinate that is not finite.
Shape read_shape(const std::filesystem::path& path);

/// The same for the bytes of a file that were read already; `path` tells the format and is what messages call it.
Shape read_shape(const std::string& bytes, const std::filesystem::path& path);

/// Looks at the header only: throws InputError where the file is absent, empty, or plainly not a shape of a format that
/// read_shape knows. Cheap enough to do for a whole data set before a long run.
void check_shape_header(const std::filesystem::path& path);

/// Writes a shape to a file, whole or not at all.
using ShapeWriter = void (*)(const std::filesystem::path&, const Shape&);

/// The writer for the format that the name's extension tells: .off (write_off) or .ply (write_ply). Throws InputError
/// for another extension.
ShapeWriter shape_writer(const std::filesystem::path& path);

}  // namespace shapegauge
