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

/// Points of a mesh, uniform by area and stratified: the area is cut, triangle after triangle, into `count` equal
/// parts, and each part has one point, which spreads them better than independent ones. Of doubled triangles only the
/// first has points. Throws InputError for a mesh whose area is zero or not finite, and for less than one point.
SurfacePoints surface_points(const Shape& mesh, Eigen::Index count, RandomNumbers& random);

/// Raised with every change of the samples of a shape (places, normals, weights), which makes cached results of earlier
/// versions stale.
inline constexpr int samples_version = 3;

/// Where a field is sampled (docs/reference/definitions.md#samples-and-weights). The points of a cloud are its
/// vertices.
enum class SampleSite {
  faces,     ///< at the triangles' centroids
  vertices,  ///< at the vertices, or the points of a cloud
  surface,   ///< at a given number of points of the surface, uniform by area
};

/// Sample points on a shape, in the order of the shape's triangles or vertices.
struct Samples {
  SampleSite site = SampleSite::faces;
  Points points;  ///< a row a sample, in the shape's units
  /// Unit normals by the triangles' orientation, or those of the cloud; zero where there is none (degenerate, unused).
  Points normals;
  Eigen::VectorXd weights;              ///< the area that each sample stands for; zero where there is none
  std::vector<std::int32_t> triangles;  ///< surface samples of a mesh: the triangle of each; otherwise empty
};

/// Samples at the centroids of the triangles (weight: the triangle's area) or at the vertices (weight: the mixed
/// Voronoi area of Meyer et al. 2003; normal: the angle-weighted mean of the triangles' normals or, where they cancel
/// as some triangles are turned over, the line along which they lie). A point cloud is sampled at its points whatever
/// the site (weight: point_weights(), whose errors it throws; normal: the file's, or unsigned_point_normals()), and the
/// result's site is `vertices`. Doubled triangles, and vertices that only they use, have the point and the normal of
/// their first, and a weight of 0 (distinct_triangles()). Throws InputError for an unusable shape (require_usable()).
Samples sample_shape(const Shape& shape, SampleSite site);

/// Samples at `count` points of the surface (SampleSite::surface; see surface_points()), with the triangles' normals
/// and equal weights that sum to the area. The same shape and seed give the same samples. Of a cloud, `count` of its
/// points at random, or all where there are no more; the result's site is then `vertices`. Throws InputError as above,
/// for a mesh without area, and for less than one sample.
Samples sample_surface_of(const Shape& shape, Eigen::Index count, std::uint64_t seed = 1);

/// A value for each sample, and the area that the sample stands for. A missing value is NaN; whoever computes or uses a
/// field reports how many there are.
struct ScalarField {
  Eigen::VectorXd values;
  Eigen::VectorXd weights;
};

}  // namespace shapegauge
