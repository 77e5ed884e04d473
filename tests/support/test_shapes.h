// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

/// Shapes of known geometry, and transformations under which measures are invariant.
namespace shapegauge::test {

/// Mesh with these vertices and triangles.
Shape mesh_of(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Eigen::Vector3i>& triangles);

/// Mesh whose triangle f has the corners 3 f to 3 f + 2.
Shape soup_of(const std::vector<Eigen::Vector3d>& corners);

/// Rectangle in the plane z = 0 with a corner at the origin: a grid of 2 nx ny triangles, whose diagonals are parallel.
Shape rectangle(double width, double height, int nx, int ny);

/// Icosahedron whose triangles are split into four `subdivisions` times, vertices on the sphere about the origin.
Shape sphere(double radius, int subdivisions);

/// Closed box about the origin with the given edge lengths; each side is a grid of 2 n^2 triangles.
Shape box(const Eigen::Vector3d& size, int n);

/// Capsule along z about the origin: a cylinder of the given length closed by half spheres.
Shape capsule(double radius, double length, int around, int rings);

/// Torus about z: tube of radius `tube` around a circle of radius `ring`.
Shape torus(double ring, double tube, int around, int along);

/// Band of `around` squares about z, closed after a number of half turns.
Shape twisted_band(int around, int half_turns);

/// Union of the parts as a triangle soup.
Shape joined(const std::vector<Shape>& parts);

/// Scaled, then rotated, then moved.
Shape transformed(const Shape& shape, double scale, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& move);

/// Triangle soup of the shape: vertex 3 f + k is corner k of triangle f.
Shape soup(const Shape& shape);

/// Flips the orientation of every triangle.
Shape flipped(const Shape& shape);

/// Reorders a shape: new vertex i is old vertex `vertices[i]`, new triangle f is old triangle `triangles[f]`,
/// and each triangle begins at another of its corners.
struct Permuted {
  Shape shape;
  std::vector<std::int32_t> vertices;
  std::vector<std::int32_t> triangles;
};
Permuted permuted(const Shape& shape, unsigned seed);

/// Random rotation, determined by the seed.
Eigen::Matrix3d rotation(unsigned seed);

/// Point cloud sampled uniformly at random from a mesh.
Shape random_points(const Shape& mesh, Eigen::Index count, std::uint64_t seed);

/// Volume of an outward-oriented closed mesh, by the divergence theorem.
double signed_volume(const Shape& mesh);

}  // namespace shapegauge::test
