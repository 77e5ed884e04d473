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

/// The shape in the bytes of a PLY file, ASCII or binary of either byte order: x, y, z of the element `vertex` and
/// `vertex_indices` (or `vertex_index`) of the element `face`; everything else is passed over. Polygons become
/// triangles; faces of fewer than three vertices leave no triangle. Without faces it is a point cloud, whose normals
/// are nx, ny, nz of the vertices, where they have them.
///
/// `name` stands in front of messages. Throws InputError, with the line or the element: truncated, index out of range,
/// coordinate that is not finite, triangle strips.
Shape read_ply(const std::string& bytes, const std::string& name);

/// Throws InputError where the bytes do not begin with the header of a PLY file that has vertices.
void check_ply_header(const std::string& bytes, const std::string& name);

/// Writes a shape, a mesh or a point cloud with its normals, as binary little-endian PLY, whole or not at all.
/// Coordinates are doubles, written exactly; a cloud has no element `face`. Throws InputError where the file cannot be
/// written, a coordinate or a cloud's normal is not finite or a triangle's vertex does not exist.
void write_ply(const std::filesystem::path& path, const Shape& shape);

/// Writes a shape with a value and a colour (red, green, blue) at each of its triangles or vertices, as above. The
/// element `face` or `vertex`, as the site says, has the properties `red`, `green`, `blue` and one of the given name (a
/// double, written exactly; NaN where a value is). A point cloud has values at its vertices.
///
/// `comment`: a line of the header, without line ends; empty: none.
///
/// Throws InputError as above, and where the numbers of values or colours are not the site's number of samples.
void write_ply(const std::filesystem::path& path, const Shape& shape, SampleSite site, const Eigen::VectorXd& values,
               const std::vector<std::array<std::uint8_t, 3>>& colours, std::string_view value_name = "sdf",
               std::string_view comment = {});

/// Writes a shape with a normal at each of its triangles or vertices: the element `face` or `vertex`, as the site says,
/// has the properties `nx`, `ny`, `nz` (doubles, written exactly). Those of the cloud itself are left out.
///
/// Throws InputError as above, and where the number of normals is not the site's number of samples.
void write_ply(const std::filesystem::path& path, Shape shape, SampleSite site, const Points& normals);

/// The entry of the registry (shape_file.h).
ShapeFormat ply_format();

}  // namespace shapegauge
