// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shapegauge {

/// n x 3 coordinates, one row per point.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// m x 3 vertex indices, one row per triangle.
using Triangles = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Polygons of a file that the triangles of a mesh belong to (polygons.h). The triangles of a polygon are consecutive,
/// in the order of the polygons.
struct Polygons {
  std::vector<std::int32_t> of_triangle = {};  ///< index of each triangle's polygon; empty if triangle i is polygon i
  std::int32_t count = 0;                      ///< number of polygons of the file; unused if `of_triangle` is empty
};

/// Triangle soup or, without triangles, point cloud.
///
/// Triangles may be non-manifold, degenerate or inconsistently oriented. Unreferenced vertices are kept in the order of
/// the file and ignored by every measure.
struct Shape {
  Points vertices;         ///< coordinates of the vertices, or of the points of a cloud
  Triangles triangles;     ///< indices of the triangles' corners in `vertices`; empty for a cloud
  Points normals = {};     ///< unit normals of a point cloud if the file has them (zero if unknown); otherwise empty
  Polygons polygons = {};  ///< polygons of the file; dropped by functions that change the list of triangles
};

/// Computes the axis-aligned bounding box of the vertices used by triangles, or of all points of a cloud. Empty for an
/// empty shape.
Eigen::AlignedBox<double, 3> bounding_box(const Shape& shape);

/// Computes the length of the bounding-box diagonal; 0 for an empty shape.
double bounding_box_diagonal(const Shape& shape);

/// Computes the area of every triangle, in the shape's units squared. A duplicate has the area of the first
/// triangle with the same corners.
Eigen::VectorXd triangle_areas(const Shape& shape);

/// Computes the unit normal of a triangle, oriented by the order of its corners (right-hand rule); zero if the triangle
/// is degenerate.
Eigen::RowVector3d triangle_normal(const Shape& mesh, Eigen::Index triangle);

/// Returns true for a triangle of zero area, up to the rounding of coordinates.
bool is_degenerate(const Shape& mesh, Eigen::Index triangle);

/// Returns true for a point cloud: a shape without triangles.
inline bool is_cloud(const Shape& shape) { return shape.triangles.rows() == 0; }

/// Returns one flag per vertex: true if a triangle uses the vertex.
std::vector<bool> used_vertices(const Shape& shape);

/// Computes the total area of the triangles, with duplicates counted once (distinct_triangles()); 0 for a point cloud.
double surface_area(const Shape& shape);

struct Welding;

/// Computes the total area of the triangles, with duplicates counted once. `welding` is the shape's welding_of().
double surface_area(const Shape& shape, const Welding& welding);

/// Describes why a shape is unusable: a coordinate that is not finite, or a vertex index out of range. Nothing for a
/// usable shape. Shapes from readers are always usable.
std::optional<std::string> find_defect(const Shape& shape);

/// Throws InputError "the shape is unusable: ..." if the shape has a defect (find_defect()).
void require_usable(const Shape& shape);

/// Coordinates in which a shape's bounding box is centred at the origin and has a diagonal of 1. Single precision and
/// fixed thresholds then work for every position and size.
struct UnitFrame {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of the bounding box, in the shape's coordinates
  double diagonal = 1;                               ///< length of the bounding-box diagonal, in the shape's units

  /// Converts the point x from the shape's coordinates to those of the frame.
  [[nodiscard]] Eigen::Vector3d to_unit(const Eigen::Vector3d& x) const { return (x - centre) / diagonal; }
};

/// Returns the frame of a shape's bounding box; with a diagonal of 1, which keeps the scale, if the box has no extent.
UnitFrame unit_frame(const Shape& shape);

/// Transforms a shape to the frame's coordinates; its normals and polygons are dropped.
Shape in_unit_frame(const Shape& shape, const UnitFrame& frame);

}  // namespace shapegauge
