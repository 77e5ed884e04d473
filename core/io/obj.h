#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// The shape in the bytes of a Wavefront OBJ file: its `v` and `f` statements (`v`, `v/vt`, `v//vn`, `v/vt/vn`; indices
/// from 1, or negative from the end), with continued lines; everything else is passed over. Polygons become triangles;
/// faces of fewer than three vertices leave no triangle. Without faces it is a point cloud; its normals are the `vn`
/// statements, in order, where there are as many as vertices.
///
/// `name` stands in front of messages. Throws InputError, with the line: index 0 or out of range, coordinate missing or
/// not finite.
Shape read_obj(const std::string& bytes, const std::string& name);

/// Throws InputError where no vertex is found in the bytes.
void check_obj_header(const std::string& bytes, const std::string& name);

/// Writes the `v` and `f` statements of a shape (and `vn` of a point cloud that has normals), whole or not at all.
/// Coordinates are written with the fewest digits that give exactly the same doubles when they are read. Throws
/// InputError where the file cannot be written, a coordinate is not finite or a triangle's vertex does not exist.
void write_obj(const std::filesystem::path& path, const Shape& shape);

/// The entry of the registry (shape_file.h).
ShapeFormat obj_format();

}  // namespace shapegauge
