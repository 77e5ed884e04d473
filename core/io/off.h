#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// The shape in the bytes of an OFF file, ASCII or binary (Geomview's manual, "OFF Files"), with what is met in the
/// wild: keyword missing, or with the counts glued to it; comments and blank lines anywhere; a wrong or missing number
/// of edges; COFF, NOFF, STOFF and combinations; extras after vertices and colours after faces, announced or not; any
/// line ends; a byte order mark; records that do not keep to lines; data after the last face. Polygons become
/// triangles; faces of fewer than three vertices leave no triangle. Without faces it is a point cloud, whose normals
/// are those that the keyword announces (NOFF).
///
/// `name` stands in front of messages. Throws InputError, with the line: truncated, index out of range, coordinate that
/// is not finite, 4OFF and nOFF (other dimensions).
Shape read_off(const std::string& bytes, const std::string& name);

/// Throws InputError where the bytes do not begin like an OFF file.
void check_off_header(const std::string& bytes, const std::string& name);

/// Writes a shape as ASCII OFF (a point cloud that has normals as NOFF), whole or not at all. Coordinates are written
/// with the fewest digits that give exactly the same doubles when they are read; the same shape gives the same bytes.
/// Throws InputError where the file cannot be written, a coordinate is not finite or a triangle's vertex does not
/// exist.
void write_off(const std::filesystem::path& path, const Shape& shape);

/// The entry of the registry (shape_file.h).
ShapeFormat off_format();

}  // namespace shapegauge
