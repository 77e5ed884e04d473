// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// Reads a shape from the bytes of an OFF file, ASCII or binary (Geomview's manual, "OFF Files"). Accepts common
/// deviations from the specification:
/// - keyword missing, or joined to the counts;
/// - comments and blank lines anywhere, any line ends, a byte order mark;
/// - a wrong or missing number of edges;
/// - COFF, NOFF, STOFF and combinations; undeclared extra values after vertices and colours after faces;
/// - records that span or share lines, and data after the last face.
///
/// Polygons become triangles; faces of fewer than three vertices are dropped. Without faces the shape is a point cloud,
/// with normals if the keyword declares them (NOFF).
///
/// `name` prefixes error messages. Throws InputError, with the line, for truncated files, indices out of range,
/// coordinates that are not finite, and other dimensions (4OFF, nOFF).
Shape read_off(const std::string& bytes, const std::string& name);

/// Throws InputError if the bytes do not begin like an OFF file.
void check_off_header(const std::string& bytes, const std::string& name);

/// Writes a shape as ASCII OFF (a point cloud with normals as NOFF), atomically. Coordinates have the fewest digits
/// that reproduce the same doubles; the same shape gives the same bytes. Throws InputError if the file cannot be
/// written, a coordinate is not finite or a vertex index is out of range.
void write_off(const std::filesystem::path& path, const Shape& shape);

/// Returns the format for shape_formats().
ShapeFormat off_format();

}  // namespace shapegauge
