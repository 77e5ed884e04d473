// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// Reads a shape from the bytes of a PLY file, ASCII or binary of either byte order: x, y, z of the element `vertex`
/// and `vertex_indices` (or `vertex_index`) of the element `face`. Other data is ignored. Polygons become triangles;
/// faces of fewer than three vertices are dropped. Without faces the shape is a point cloud, with normals from the
/// vertex properties nx, ny, nz if present.
///
/// `name` prefixes error messages. Throws InputError, with the line or the element, for truncated files, indices out of
/// range, and coordinates that are not finite. Triangle strips (the element tristrips) are read as triangles.
Shape read_ply(const std::string& bytes, const std::string& name);

/// Throws InputError if the bytes do not begin with the header of a PLY file that has vertices.
void check_ply_header(const std::string& bytes, const std::string& name);

/// Writes a mesh, or a point cloud with its normals, as binary little-endian PLY, atomically. Coordinates are doubles,
/// written exactly; a cloud has no element `face`. Throws InputError if the file cannot be written, a coordinate or
/// normal is not finite or a vertex index is out of range.
void write_ply(const std::filesystem::path& path, const Shape& shape);

/// Writes a shape as PLY with a value and a colour (red, green, blue) at each triangle or vertex. According to `site`,
/// the element `face` or `vertex` has the properties `red`, `green`, `blue` and one called `value_name` (a double,
/// written exactly, possibly NaN). A point cloud has values at its vertices.
///
/// `comment` is a line of the header, without line ends; empty for none.
///
/// Throws InputError as write_ply() of a shape does, and if the number of values or colours differs from the number of
/// samples of the site.
void write_ply(const std::filesystem::path& path, const Shape& shape, SampleSite site, const Eigen::VectorXd& values,
               const std::vector<std::array<std::uint8_t, 3>>& colours, std::string_view value_name = "sdf",
               std::string_view comment = {});

/// Writes a shape as PLY with a normal at each triangle or vertex. According to `site`, the element `face` or `vertex`
/// has the properties `nx`, `ny`, `nz` (doubles, written exactly). The normals of a cloud itself are omitted.
///
/// Throws InputError as write_ply() of a shape does, and if the number of normals differs from the number of samples of
/// the site.
void write_ply(const std::filesystem::path& path, Shape shape, SampleSite site, const Points& normals);

/// Returns the format for shape_formats().
ShapeFormat ply_format();

}  // namespace shapegauge
