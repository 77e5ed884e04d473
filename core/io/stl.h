#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// The shape in the bytes of an STL file, ASCII or binary (also where its free header begins with "solid"). Corners
/// with equal coordinates become one vertex, in the order of their first appearance: the format has no indices. Normals
/// and attributes are passed over.
///
/// `name` stands in front of messages. Throws InputError, with the line or the facet: truncated, coordinate that is not
/// finite.
Shape read_stl(const std::string& bytes, const std::string& name);

/// Throws InputError where the bytes do not begin like an STL file.
void check_stl_header(const std::string& bytes, const std::string& name);

/// Writes a mesh as binary STL, whole or not at all: the corners of every triangle, rounded to single precision, with
/// the triangle's normal. Indices are lost, and with them vertices that no triangle uses; vertices that round to the
/// same place are one when the file is read. Throws InputError for a point cloud, for a coordinate that is not finite
/// in single precision, where a triangle's vertex does not exist, and where the file cannot be written.
void write_stl(const std::filesystem::path& path, const Shape& shape);

/// The entry of the registry (shape_file.h).
ShapeFormat stl_format();

}  // namespace shapegauge
