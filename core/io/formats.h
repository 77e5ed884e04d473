// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_source.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

/// Readers and writers of the built-in shape formats, each format in a source file of its own.
namespace shapegauge {

/// Returns the built-in entry of shape_formats() for the file format that the function is named after.
/// @{
ShapeFormat off_format();   ///< returns the format OFF (Geomview)
ShapeFormat obj_format();   ///< returns the format OBJ (Wavefront)
ShapeFormat ply_format();   ///< returns the format PLY (Stanford)
ShapeFormat stl_format();   ///< returns the format STL
ShapeFormat gltf_format();  ///< returns the format glTF 2.0
ShapeFormat xyz_format();   ///< returns the format of text files of points
/// @}

/// Throws InputError, prefixed by `name`, unless the beginning of a file looks like a text file of points (read_xyz()).
void check_xyz_header(const std::string& bytes, const std::string& name);

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

/// Writes a shape as ASCII OFF (a point cloud with normals as NOFF), atomically. Coordinates have the fewest digits
/// that reproduce the same doubles; the same shape gives the same bytes. Throws InputError if the file cannot be
/// written, a coordinate is not finite or a vertex index is out of range. `comment` is the last line; empty for none.
void write_off(const std::filesystem::path& path, const Shape& shape, std::string_view comment = {});

/// Reads a shape from the bytes of a Wavefront OBJ file: its `v` and `f` statements (`v`, `v/vt`, `v//vn`, `v/vt/vn`;
/// indices from 1, or negative from the end), with continued lines. Other statements are ignored. Polygons become
/// triangles; faces of fewer than three vertices are dropped. Without faces the shape is a point cloud; its normals are
/// the `vn` statements, in order, if there are as many as vertices.
///
/// `name` prefixes error messages. Throws InputError, with the line, for an index that is 0 or out of range and for a
/// coordinate that is missing or not finite.
Shape read_obj(const std::string& bytes, const std::string& name);

/// Writes the `v` and `f` statements of a shape (and `vn` of a point cloud with normals), atomically. Coordinates have
/// the fewest digits that reproduce the same doubles. Throws InputError if the file cannot be written, a coordinate is
/// not finite or a vertex index is out of range. `comment` is the last line; empty for none.
void write_obj(const std::filesystem::path& path, const Shape& shape, std::string_view comment = {});

/// Reads a shape from the bytes of a PLY file, ASCII or binary of either byte order: x, y, z of the element `vertex`
/// and `vertex_indices` (or `vertex_index`) of the element `face`. Other data is ignored. Polygons become triangles;
/// faces of fewer than three vertices are dropped. Without faces the shape is a point cloud, with normals from the
/// vertex properties nx, ny, nz if present.
///
/// `name` prefixes error messages. Throws InputError, with the line or the element, for truncated files, indices out of
/// range, and coordinates that are not finite. Triangle strips (the element tristrips) are read as triangles.
Shape read_ply(const std::string& bytes, const std::string& name);

/// Writes a mesh, or a point cloud with its normals, as binary little-endian PLY, atomically. Coordinates are doubles,
/// written exactly; a cloud has no element `face`. Throws InputError if the file cannot be written, a coordinate or
/// normal is not finite or a vertex index is out of range. Ignores `comment` (ShapeWriter).
void write_ply(const std::filesystem::path& path, const Shape& shape, std::string_view comment = {});

/// Writes a shape as PLY with a value and a colour (red, green, blue) at each triangle or vertex. According to `site`,
/// the element `face` or `vertex` has the properties `red`, `green`, `blue` and one called `value_name` (a double,
/// written exactly, possibly NaN). A point cloud has values at its vertices.
///
/// `comment` is a line of the header, without line ends; empty for none.
///
/// Throws InputError as write_ply() of a shape does, and if the number of values or colours differs from the number of
/// triangles or vertices.
void write_ply(const std::filesystem::path& path, const Shape& shape, SampleSite site, const Eigen::VectorXd& values,
               const std::vector<std::array<std::uint8_t, 3>>& colours, std::string_view value_name = "sdf",
               std::string_view comment = {});

/// Writes a shape as PLY with a normal at each triangle or vertex. According to `site`, the element `face` or `vertex`
/// has the properties `nx`, `ny`, `nz` (doubles, written exactly). Normals that a cloud has itself (Shape::normals)
/// are omitted.
///
/// Throws InputError as write_ply() of a shape does, and if the number of normals differs from the number of triangles
/// or vertices.
void write_ply(const std::filesystem::path& path, Shape shape, SampleSite site, const Points& normals);

/// Reads a shape from the bytes of an STL file, ASCII or binary (even if the binary header begins with "solid"). STL
/// has no indices: corners with equal coordinates become one vertex, in the order of first appearance. Normals and
/// attributes are ignored.
///
/// `name` prefixes error messages. Throws InputError, with the line or the facet, for truncated files and coordinates
/// that are not finite.
Shape read_stl(const std::string& bytes, const std::string& name);

/// Writes a mesh as binary STL, atomically: the corners of every triangle, rounded to single precision, and its normal.
/// Indices and unused vertices are lost; vertices that round to equal coordinates are merged on reading. Throws
/// InputError for a point cloud, a coordinate that is not finite in single precision, a vertex index out of range, and
/// if the file cannot be written. Ignores `comment` (ShapeWriter).
void write_stl(const std::filesystem::path& path, const Shape& shape, std::string_view comment = {});

/// Returns a warning, as a sentence, if `path` has the extension of STL and its single precision moves vertices of the
/// shape's triangles by more than 1e-4 of the bounding-box diagonal or makes distinct ones equal. Nothing for other
/// formats.
std::optional<std::string> precision_warning(const std::filesystem::path& path, const Shape& shape);

/// Reads the meshes of a glTF 2.0 file (JSON or binary, GLB), transformed by the nodes of its scene: triangles, strips
/// and fans, or points if there is nothing else. By the standard, coordinates are in metres and y is up. Vertices and
/// faces keep the order of nodes and primitives; a mesh used by several nodes occurs several times. Materials, images,
/// skins, morph targets and animations are ignored. Buffers may be in the file, in data URIs or in files next to it.
///
/// Throws InputError for files that are not glTF, compressed meshes (Draco, meshopt), missing or truncated buffers,
/// indices out of range, coordinates that are not finite, cyclic nodes, and scenes of more than 100 million vertices.
Shape read_gltf(const ShapeSource& source);

/// Reads a point cloud from the bytes of a text file with one point per line (.xyz, .pwn, .pts, .txt). Every line has
/// the same number of columns, at least three, separated by white space, commas or semicolons. `#` and `//` begin
/// comments. Blank lines, any line ends and a byte order mark are accepted.
///
/// The first three columns are coordinates. Columns 4 to 6 are normals if at least nine in ten of their non-zero
/// vectors have a length from 0.95 to 1.05 and a component is negative, unlike in colours and labels; otherwise they
/// are ignored, like all further columns. Zero normals stay zero; if all are zero, the cloud has no normals. The first
/// line may consist of the names of the columns, which begin with x, y and z (and nx, ny and nz for normals), or of the
/// number of points n. After n points, the number of points of another scan may follow. If 2n lines of three columns
/// follow (the PWN format), the second half are normals of any length.
///
/// `name` prefixes error messages. Throws InputError, with the line, for a coordinate or normal that is missing, not a
/// number or not finite; an inconsistent number of columns; a number of points that differs from the first line; and
/// decimal commas.
Shape read_xyz(const std::string& bytes, const std::string& name);

}  // namespace shapegauge
