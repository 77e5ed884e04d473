// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/base/words.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Points on a mesh and the triangles that contain them.
struct SurfacePoints {
  Points points;                        ///< one row per point, in the mesh's units
  std::vector<std::int32_t> triangles;  ///< per point: index of the triangle that contains it
};

/// Samples a mesh by points, stratified and uniform by area: the concatenated triangle areas are divided into `count`
/// equal parts with one point each. Of duplicate triangles only the first is sampled. Throws InputError for a mesh
/// whose area is zero or not finite, and for less than one point.
SurfacePoints stratified_points(const Shape& mesh, Eigen::Index count, RandomNumbers& random);

/// Cache version of the samples of a shape (positions, normals, weights); see docs/manual/cache.md.
inline constexpr int samples_version = 4;

/// Sampling sites of a field (docs/reference/definitions.md#samples-and-weights). The points of a cloud are its
/// vertices.
enum class SampleSite {
  faces,     ///< at the triangles' centroids
  vertices,  ///< at the vertices, or the points of a cloud
  surface,   ///< at a given number of points of the surface, uniform by area
};
template <>
inline constexpr std::array<std::string_view, 3> words_of<SampleSite>{"faces", "vertices", "surface"};

/// Sample points on a shape, in the order of the shape's triangles or vertices.
struct Samples {
  SampleSite site = SampleSite::faces;  ///< faces, vertices or surface: where the samples are
  Points points;                        ///< one row per sample, in the shape's units
  /// Unit normal of each sample, by the triangles' orientation or of the cloud; zero if undefined (degenerate triangle,
  /// unused vertex).
  Points normals;
  Eigen::VectorXd weights;  ///< area represented by each sample, in the shape's units squared; zero if undefined
  std::vector<std::int32_t> triangles;  ///< index of each sample's triangle if `site` is surface; otherwise empty
};

/// Samples a shape at its triangles' centroids or at its vertices.
/// - Faces: the weight is the triangle's area.
/// - Vertices: the weight is the mixed Voronoi area (Meyer et al. 2003); the normal is the angle-weighted mean of the
///   triangles' normals or, if they cancel because of reversed triangles, the axis along which they lie.
/// - Clouds: the samples are the points, whatever the site, and the result's site is `vertices`. The weights are
///   point_weights(), with their errors; the normals are the file's or unsigned_point_normals().
///
/// Duplicate triangles, and vertices that only they use, have the point and normal of the first duplicate and a weight
/// of 0 (distinct_triangles()). Throws InputError for an unusable shape (require_usable()).
Samples sample_shape(const Shape& shape, SampleSite site);

/// Samples a shape at `count` points of the surface (SampleSite::surface, stratified_points()), with the triangles'
/// normals and equal weights that sum to the area. Deterministic for the same shape. Of a cloud, selects
/// `count` points at random, or all if there are no more; the result's site is then `vertices`. Throws InputError as
/// sample_shape() does, for a mesh without area, and for less than one sample.
Samples sample_surface(const Shape& shape, Eigen::Index count);

/// Scalar field on a shape: the value and represented area of each sample. Code that computes or uses a field reports
/// the number of missing values.
struct ScalarField {
  Eigen::VectorXd values;   ///< value at each sample; NaN if missing
  Eigen::VectorXd weights;  ///< area represented by each sample (Samples::weights)
};

}  // namespace shapegauge
