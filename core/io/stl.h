// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// Reads a shape from the bytes of an STL file, ASCII or binary (even if the binary header begins with "solid"). STL
/// has no indices: corners with equal coordinates become one vertex, in the order of first appearance. Normals and
/// attributes are ignored.
///
/// `name` prefixes error messages. Throws InputError, with the line or the facet, for truncated files and coordinates
/// that are not finite.
Shape read_stl(const std::string& bytes, const std::string& name);

/// Throws InputError if the bytes do not begin like an STL file.
void check_stl_header(const std::string& bytes, const std::string& name);

/// Writes a mesh as binary STL, atomically: the corners of every triangle, rounded to single precision, and its normal.
/// Indices and unused vertices are lost; vertices that round to equal coordinates are merged on reading. Throws
/// InputError for a point cloud, a coordinate that is not finite in single precision, a vertex index out of range, and
/// if the file cannot be written.
void write_stl(const std::filesystem::path& path, const Shape& shape);

/// Returns a warning, as a sentence, if the file is STL and single precision moves vertices of the shape's triangles by
/// more than 1e-4 of the bounding-box diagonal or makes distinct ones equal. Nothing for other formats.
std::optional<std::string> precision_warning(const std::filesystem::path& path, const Shape& shape);

/// Returns the format for shape_formats().
ShapeFormat stl_format();

}  // namespace shapegauge
