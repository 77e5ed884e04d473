// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

/// Polygons of a file, which are triangulated on reading, and values or labels per polygon.

namespace shapegauge {

/// Returns true if the triangles of a mesh are not simply the faces of its file, one triangle per face in order.
inline bool has_polygons(const Shape& shape) { return !shape.polygons.of_triangle.empty(); }

/// Returns the number of polygons of the mesh's file, including those without a triangle. For a mesh that was not read
/// from a file, the number of triangles.
Eigen::Index polygon_count(const Shape& shape);

/// Returns the index of the polygon that the triangle belongs to.
inline std::int32_t polygon_of(const Shape& shape, Eigen::Index triangle) {
  return has_polygons(shape) ? shape.polygons.of_triangle[static_cast<std::size_t>(triangle)]
                             : static_cast<std::int32_t>(triangle);
}

/// Returns one weight per triangle: 1 / number of triangles of its polygon, so that every polygon has a weight of 1.
std::vector<double> polygon_shares(const Shape& shape);

/// Converts segment labels per triangle to labels per polygon of the file: the label with the largest area within each
/// polygon. Of equal areas the smallest label wins. Polygons without a triangle get the label 0.
std::vector<std::int32_t> labels_of_polygons(const Shape& shape, std::span<const std::int32_t> of_triangles);

/// Converts segment labels per polygon of the file, polygon_count() labels, to labels per triangle.
std::vector<std::int32_t> labels_of_triangles(const Shape& shape, std::span<const std::int32_t> of_polygons);

/// Returns the text "5 faces of the file became 9 triangles", the beginning of a note on values or labels per triangle;
/// nothing unless the mesh has_polygons().
std::optional<std::string> polygon_note(const Shape& shape);

}  // namespace shapegauge
