#pragma once

#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// The point cloud in the bytes of a text file with a point a line (.xyz, .pwn, .pts, .txt): three or more columns,
/// separated by white space, commas or semicolons, as many on every line; `#` and `//` begin comments; blank lines, any
/// line ends and a byte order mark are passed over.
///
/// The first three columns are the coordinates. Columns 4 to 6 are a normal where at least nine in ten of those vectors
/// that are not zero have a length between 0.95 and 1.05, otherwise colours or the like, which are passed over as all
/// further columns are. A zero normal stays zero. The first line may hold the number of points n alone; of 2n lines of
/// three columns that follow (the PWN format), the second half are the normals, whatever their lengths.
///
/// `name` stands in front of messages. Throws InputError, with the line: coordinate or normal that is missing, no
/// number or not finite; another number of columns than on the first line; another number of points than the first line
/// says; decimal commas.
Shape read_xyz(const std::string& bytes, const std::string& name);

/// Throws InputError where the bytes do not begin with a number of points or a point.
void check_xyz_header(const std::string& bytes, const std::string& name);

/// The entry of the registry (shape_file.h).
ShapeFormat xyz_format();

}  // namespace shapegauge
