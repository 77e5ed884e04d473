// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// Reads a shape from the bytes of a Wavefront OBJ file: its `v` and `f` statements (`v`, `v/vt`, `v//vn`, `v/vt/vn`;
/// indices from 1, or negative from the end), with continued lines. Other statements are ignored. Polygons become
/// triangles; faces of fewer than three vertices are dropped. Without faces the shape is a point cloud; its normals are
/// the `vn` statements, in order, if there are as many as vertices.
///
/// `name` prefixes error messages. Throws InputError, with the line, for an index that is 0 or out of range and for a
/// coordinate that is missing or not finite.
Shape read_obj(const std::string& bytes, const std::string& name);

/// Throws InputError if the bytes contain no vertex.
void check_obj_header(const std::string& bytes, const std::string& name);

/// Writes the `v` and `f` statements of a shape (and `vn` of a point cloud with normals), atomically. Coordinates have
/// the fewest digits that reproduce the same doubles. Throws InputError if the file cannot be written, a coordinate is
/// not finite or a vertex index is out of range.
void write_obj(const std::filesystem::path& path, const Shape& shape);

/// Returns the format for shape_formats().
ShapeFormat obj_format();

}  // namespace shapegauge
