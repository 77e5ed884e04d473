#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

namespace shapegauge {

/// n x 3 coordinates, one point a row.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// m x 3 vertex indices, one triangle a row.
using Triangles = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A shape: a triangle soup or, where there are no triangles, a point cloud.
///
/// Nothing is assumed of the triangles: they may be non-manifold, degenerate, or oriented at random. Vertices that no
/// triangle uses are kept, in the order of the file, and count for nothing.
struct Shape {
  Points vertices;
  Triangles triangles;
  Points normals = {};  ///< unit normals of a point cloud's points, where the file gives them; otherwise empty
};

/// The axis-aligned box around the vertices that count: those that a triangle uses, or all of them where there are no
/// triangles. Empty for an empty shape.
Eigen::AlignedBox3d bounding_box(const Shape& shape);

/// Length of the diagonal of the bounding box; 0 for an empty shape.
double bounding_box_diagonal(const Shape& shape);

/// Area of every triangle, in the shape's units squared.
Eigen::VectorXd triangle_areas(const Shape& shape);

/// Whether there is nothing but points.
inline bool is_cloud(const Shape& shape) { return shape.triangles.rows() == 0; }

/// Sum of the triangles' areas; 0 for a point cloud.
double surface_area(const Shape& shape);

/// What makes a shape unusable: a coordinate that is not a finite number, or a triangle with a vertex that there is
/// not. Nothing where it is usable, as every shape from a reader is.
std::optional<std::string> defect_of(const Shape& shape);

/// Throws InputError "the shape is unusable: ..." where a shape has a defect.
void require_usable(const Shape& shape);

/// The coordinates in which a shape lies about the origin with a diagonal of 1, so that single precision and fixed
/// thresholds serve whatever the shape's place and size.
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
