// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

/// Shapes of known geometry, and transformations under which measures are invariant.
namespace shapegauge::test {

/// Returns the mesh with the given vertices and triangles.
Shape mesh_of(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Eigen::Vector3i>& triangles);

/// Returns the mesh whose triangle f has the vertices 3 f to 3 f + 2, at the positions `corners`.
Shape soup_of(const std::vector<Eigen::Vector3d>& corners);

/// Returns a rectangle (width along x, height along y) in the plane z = 0 with a corner at the origin: a grid of nx by
/// ny cells of two triangles, with parallel diagonals.
Shape rectangle(double width, double height, int nx, int ny);

/// Returns a triangulated sphere about the origin: an icosahedron whose triangles are split into four `subdivisions`
/// times.
Shape sphere(double radius, int subdivisions);

/// Returns a closed box about the origin with the edge lengths `size`; each side is a grid of 2 n^2 triangles.
Shape box(const Eigen::Vector3d& size, int n);

/// Returns a capsule along z about the origin: a cylinder of the given length closed by half spheres, with `around`
/// vertices per circle and `rings` bands of faces per half sphere.
Shape capsule(double radius, double length, int around, int rings);

/// Returns a torus about z: a tube of radius `tube` around a circle of radius `ring`, with `around` vertices around the
/// tube and `along` vertices along the circle.
Shape torus(double ring, double tube, int around, int along);

/// Returns an open band of `around` quadrilaterals about z, twisted by `half_turns` half turns: a Moebius strip if odd.
Shape twisted_band(int around, int half_turns);

/// Concatenates the vertices and triangles of several shapes, without welding.
Shape joined(const std::vector<Shape>& parts);

/// Returns the shape scaled about the origin, then rotated, then moved.
Shape transformed(const Shape& shape, double scale, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& move);

/// Returns the triangle soup of a shape, without shared vertices: vertex 3 f + k is corner k of triangle f.
Shape soup(const Shape& shape);

/// Returns the shape with the orientation of every triangle reversed.
Shape flipped(const Shape& shape);

/// Shape with reordered vertices and triangles (permuted()).
struct Permuted {
  Shape shape;                          ///< reordered shape
  std::vector<std::int32_t> vertices;   ///< per new vertex: index of the old vertex
  std::vector<std::int32_t> triangles;  ///< per new triangle: index of the old triangle
};
/// Returns a mesh with its vertices and triangles in random order, and the corners of triangles rotated.
Permuted permuted(const Shape& shape, unsigned seed);

/// Returns a random rotation matrix, determined by the seed.
Eigen::Matrix3d rotation(unsigned seed);

/// Returns a point cloud of `count` points sampled from a mesh, uniformly at random by area.
Shape random_points(const Shape& mesh, Eigen::Index count, std::uint64_t seed);

/// Returns the volume of an outward-oriented closed mesh, by the divergence theorem.
double signed_volume(const Shape& mesh);

}  // namespace shapegauge::test
