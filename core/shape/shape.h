#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shapegauge {

/// n x 3 coordinates, a row a point.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// m x 3 vertex indices, a row a triangle.
using Triangles = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// The polygons of a file that the triangles of a mesh are parts of (polygons.h). The triangles of a polygon follow
/// each other, in the order of the polygons.
struct Polygons {
  std::vector<std::int32_t> of_triangle = {};  ///< empty where triangle i is polygon i
  std::int32_t count = 0;                      ///< of the file; not used where `of_triangle` is empty
};

/// A shape: a triangle soup or, where there are no triangles, a point cloud.
///
/// Nothing is assumed of the triangles: they may be non-manifold, degenerate, or inconsistently oriented. Unreferenced
/// vertices are kept, in the order of the file, and are ignored by every measure.
struct Shape {
  Points vertices;
  Triangles triangles;
  Points normals = {};     ///< unit normals of a point cloud's points, where the file gives them; otherwise empty
  Polygons polygons = {};  ///< as the mesh was read; what changes the list of triangles drops them
};

/// The axis-aligned bounding box of the vertices that a triangle uses, or of all points of a cloud. Empty for an empty
/// shape.
Eigen::AlignedBox3d bounding_box(const Shape& shape);

/// Length of the diagonal of the bounding box; 0 for an empty shape.
double bounding_box_diagonal(const Shape& shape);

/// Area of every triangle, in the shape's units squared; doubles have that of their first.
Eigen::VectorXd triangle_areas(const Shape& shape);

/// Whether the shape is a point cloud: it has no triangles.
inline bool is_cloud(const Shape& shape) { return shape.triangles.rows() == 0; }

/// For each vertex, whether a triangle uses it.
std::vector<bool> used_vertices(const Shape& shape);

/// Sum of the triangles' areas, doubled ones counted once (distinct_triangles()); 0 for a point cloud.
double surface_area(const Shape& shape);

/// What makes a shape unusable: a coordinate that is not finite, or a vertex index out of range. Nothing for a usable
/// shape, as every shape from a reader is.
std::optional<std::string> defect_of(const Shape& shape);

/// Throws InputError "the shape is unusable: ..." where the shape has a defect.
void require_usable(const Shape& shape);

/// Coordinates in which a shape's bounding box is centred at the origin and has a diagonal of 1, so that single
/// precision and fixed thresholds serve for every position and size.
struct UnitFrame {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double diagonal = 1;

  [[nodiscard]] Eigen::Vector3d to_unit(const Eigen::Vector3d& x) const { return (x - centre) / diagonal; }
};

/// The frame of a shape's bounding box; one of size 1 where the box has no extent.
UnitFrame unit_frame(const Shape& shape);

/// The shape in the frame's coordinates, without normals.
Shape in_unit_frame(const Shape& shape, const UnitFrame& frame);

}  // namespace shapegauge
