#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Points on a mesh, and the triangle on which each lies.
struct SurfacePoints {
  Points points;
  std::vector<std::int32_t> triangles;
};

/// So many points of a mesh, uniform by area. The area is cut, triangle after triangle, into as many equal parts as
/// there are to be points, and each part has one point: that spreads them better than independent ones. Throws
/// InputError for a mesh whose area is zero or not finite, and for less than one point.
SurfacePoints surface_points(const Shape& mesh, Eigen::Index count, RandomNumbers& random);

/// To be raised with every change of the samples that a shape is given (places, normals, weights): what a cache holds
/// of earlier versions is then computed anew.
inline constexpr int samples_version = 1;

/// Where a field is sampled (the design, section 2.4). The points of a cloud are its vertices.
enum class SampleSite {
  faces,     ///< at the triangles' centroids
  vertices,  ///< at the vertices, or the points of a cloud
  surface,   ///< at so many places of the surface, uniform by area
};

/// Sample points on a shape, in the order of the shape's triangles or vertices.
struct Samples {
  SampleSite site = SampleSite::faces;
  Points points;  ///< one sample a row, in the shape's units
  /// Unit normals by the triangles' orientation, or those of the cloud; zero where there is none (degenerate, unused).
  Points normals;
  Eigen::VectorXd weights;              ///< area that the sample stands for; zero where there is none
  std::vector<std::int32_t> triangles;  ///< surface, of a mesh: on which each sample lies; otherwise empty
};

/// Samples at the centroids of the triangles (weight: the triangle's area) or at the vertices (weight: the mixed
/// Voronoi area of Meyer et al. 2003; normal: the angle-weighted mean of the triangles' normals). A point cloud
/// is sampled at its points whatever the site (weight: see point_weights(), whose errors it throws; normal: the
/// file's, or without those unsigned_point_normals()), and the samples say `vertices`. Throws InputError where the
/// shape is unusable (validity.h).
Samples sample_shape(const Shape& shape, SampleSite site);

/// Samples at so many places of the surface (SampleSite::surface; see surface_points()), with the triangles' normals
/// and equal weights that sum to the area. They are the same for the same shape and seed. Of a cloud, so many of its
/// points at random, or all where there are no more; the samples say `vertices` then. Throws InputError as above, for a
/// mesh without area, and for less than one sample.
Samples sample_surface_of(const Shape& shape, Eigen::Index count, std::uint64_t seed = 1);

/// One value per sample with the area that the sample stands for. A value that could not be found is NaN, and whoever
/// computes or uses a field says how many there are.
struct ScalarField {
  Eigen::VectorXd values;
  Eigen::VectorXd weights;
};

}  // namespace shapegauge
