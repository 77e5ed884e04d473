// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// Reads a point cloud from the bytes of a text file with one point per line (.xyz, .pwn, .pts, .txt). Every line has
/// the same number of columns, at least three, separated by white space, commas or semicolons. `#` and `//` begin
/// comments. Blank lines, any line ends and a byte order mark are accepted.
///
/// The first three columns are coordinates. Columns 4 to 6 are normals if at least nine in ten of their non-zero
/// vectors have a length from 0.95 to 1.05 and a component is negative, unlike in colours and labels; otherwise they
/// are ignored, like all further columns. Zero normals stay zero; if all are, the cloud has none. The first line may
/// consist of the names of the columns, which begin with x, y and z (and nx, ny and nz for normals), or of the number
/// of points n. After n points, the number of points of another scan may follow. If 2n lines of three columns follow
/// (the PWN format), the second half are normals of any length.
///
/// `name` prefixes error messages. Throws InputError, with the line, for a coordinate or normal that is missing, not a
/// number or not finite; an inconsistent number of columns; a number of points that differs from the first line; and
/// decimal commas.
Shape read_xyz(const std::string& bytes, const std::string& name);

/// Throws InputError if the bytes do not begin with a number of points or a point.
void check_xyz_header(const std::string& bytes, const std::string& name);

/// Returns the format for shape_formats().
ShapeFormat xyz_format();

}  // namespace shapegauge
