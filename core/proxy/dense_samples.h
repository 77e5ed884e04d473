#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Samples from which a surface proxy is chosen, in an order that depends on the surface alone: not on the order of
/// faces, vertices and corners, nor on the orientation of faces.
struct DenseSamples {
  Points points;
  Points normals;                    ///< unit vectors; zero where there is none
  Eigen::VectorXd areas;             ///< the area that each sample stands for, positive
  std::vector<std::int32_t> sheets;  ///< within a sheet normals are consistently oriented; across sheets the sign means
                                     ///< nothing. -1: in no sheet
  std::vector<std::int32_t> triangles;  ///< of the mesh, on which each lies; empty for a cloud
};

/// Cosine of the angle between the normals of two samples; its absolute value where their orientations are unrelated.
inline double normal_agreement(const Points& normals, const std::vector<std::int32_t>& sheets, std::int32_t i,
                               std::int32_t j) {
  const double product = normals.row(i).dot(normals.row(j));
  const std::int32_t sheet = sheets[static_cast<std::size_t>(i)];
  return sheet >= 0 && sheet == sheets[static_cast<std::size_t>(j)] ? product : std::abs(product);
}

/// Samples a mesh at `count` points, uniform by area and stratified along a Morton curve of its triangles; doubled
/// triangles count once. Sheets are the pieces that edges of exactly two triangles join, as far as they can be
/// oriented.
///
/// Takes the distinct points of a cloud, weighted by point_weights(), with unsigned_point_normals(); of more than
/// `count` points every so many-th along a Morton curve. All are in no sheet.
///
/// `uses` are the mesh's edge_uses(). Throws InputError where the shape has no area.
DenseSamples dense_samples(const Shape& shape, std::span<const EdgeUse> uses, Eigen::Index count);

}  // namespace shapegauge
