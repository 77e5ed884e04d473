#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

/// The polygons of a file, which become triangles when it is read, and values or labels per polygon.

namespace shapegauge {

/// Whether the triangles of a mesh differ from the faces of its file: triangle i is not face i.
inline bool has_polygons(const Shape& shape) { return !shape.polygons.of_triangle.empty(); }

/// Number of polygons of the file that the mesh was read from, also those without a triangle; for a mesh that was not
/// read from a file the number of triangles.
Eigen::Index polygon_count(const Shape& shape);

/// Index of the polygon that the triangle is a part of.
inline std::int32_t polygon_of(const Shape& shape, Eigen::Index triangle) {
  return has_polygons(shape) ? shape.polygons.of_triangle[static_cast<std::size_t>(triangle)]
                             : static_cast<std::int32_t>(triangle);
}

/// Weight of each triangle if every polygon has a weight of 1, shared evenly by its triangles.
std::vector<double> polygon_shares(const Shape& shape);

/// Labels of the polygons: each has the label with the largest area among its triangles. Of equal areas the smallest
/// label wins; polygons without a triangle have the label 0.
std::vector<std::int32_t> labels_of_polygons(const Shape& shape, std::span<const std::int32_t> of_triangles);

/// Labels of the triangles: each has that of its polygon. Takes polygon_count() labels.
std::vector<std::int32_t> labels_of_triangles(const Shape& shape, std::span<const std::int32_t> of_polygons);

/// Beginning of a note to users on values or labels of a mesh that has_polygons(); nothing for any other shape.
std::optional<std::string> polygon_note(const Shape& shape);

}  // namespace shapegauge
