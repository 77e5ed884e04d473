// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Dense samples from which the points of a surface proxy are chosen. Their order depends only on the surface: not on
/// the order of faces, vertices and corners, nor on the orientation of faces.
struct DenseSamples {
  Points points;          ///< positions of the samples, in the shape's units
  Points normals;         ///< unit normal of each sample; zero if undefined
  Eigen::VectorXd areas;  ///< area represented by each sample, positive, in the shape's units squared
  /// Index of the sheet (orientable piece of a mesh) that contains each sample; -1 for none, as in a cloud. Not every
  /// index is used. Normals are consistently oriented within a sheet only.
  std::vector<std::int32_t> sheets;
  /// Index of the triangle of the mesh that contains each sample; empty for a cloud.
  std::vector<std::int32_t> triangles;
};

/// Returns the cosine of the angle between the normals of two samples; its absolute value if they are not in the same
/// sheet.
inline double normal_agreement(const DenseSamples& samples, std::int32_t i, std::int32_t j) {
  const double product = samples.normals.row(i).dot(samples.normals.row(j));
  const std::int32_t sheet = samples.sheets[static_cast<std::size_t>(i)];
  return sheet >= 0 && sheet == samples.sheets[static_cast<std::size_t>(j)] ? product : std::abs(product);
}

/// Returns true if two samples probably lie on the same sheet, judged by the angle between their normals and their
/// distances from each other's tangent plane. `distance` is the distance between the samples, positive. On a circular
/// arc that turns by t between the samples, both distances are sin(t / 2) times the distance between the samples.
bool on_same_sheet(const DenseSamples& samples, std::int32_t i, std::int32_t j, double distance);

/// Samples a mesh at `count` points, uniform by area and stratified along a Morton curve of its triangles. Duplicate
/// triangles count once. Sheets are the orientable pieces connected by edges of exactly two triangles.
///
/// For a cloud, returns the distinct points, weighted by point_weights(), with unsigned_point_normals(), in no sheet.
/// From more than `count` points, selects evenly along a Morton curve.
///
/// `uses` are the mesh's half_edges(). Throws InputError if the shape has no area.
DenseSamples dense_samples(const Shape& shape, std::span<const HalfEdge> uses, Eigen::Index count);

}  // namespace shapegauge
