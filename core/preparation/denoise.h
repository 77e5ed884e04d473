// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Vertex adjacency: the vertices that share an edge with each vertex, in ascending order. Coincident vertices are
/// welded: they have the same neighbours, and only the first of coincident neighbours is listed. Vertices used only by
/// duplicate triangles have no neighbours (distinct_triangles()).
struct VertexNeighbours {
  /// Per vertex: index in `neighbours` of its first neighbour; last entry: number of all neighbours.
  std::vector<std::size_t> first;
  std::vector<std::int32_t> neighbours;  ///< indices of all neighbours, vertex by vertex

  /// Returns the indices of the neighbours of a vertex.
  [[nodiscard]] std::span<const std::int32_t> of(Eigen::Index vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(neighbours).subspan(first[v], first[v + 1] - first[v]);
  }
};

/// Computes the vertex adjacency of a usable shape from its welding_of(); empty without triangles.
VertexNeighbours vertex_neighbours(const Shape& shape, const Welding& welding);

/// Estimated noise of the vertices of a mesh (noise_level()).
struct NoiseLevel {
  double deviation = 0;    ///< standard deviation of the noise along the normal, in the shape's units
  double edge_length = 0;  ///< mean edge length of the smoothed mesh, in the shape's units
  /// Fraction of edges whose ends lie on the same side of the smoothed mesh. About 0.46 for independent heights
  /// (noise), 0.6 and more for geometric features (ridges, creases, coarse curved parts).
  double agreement = 1;

  /// Returns the noise in edge lengths, deviation / edge_length: 0.02 to 0.05 on clean, fine meshes; 0 without edges.
  [[nodiscard]] double relative() const { return edge_length > 0 ? deviation / edge_length : 0; }
};

/// Estimates the noise of a mesh: independent displacements of its vertices along the normal. `neighbours` is the
/// shape's vertex_neighbours() and `welding` its welding_of().
///
/// The standard deviation follows from the median absolute difference between a vertex's height above the smoothed mesh
/// and the mean height of its neighbours. This ignores slow variation and outliers. On coarse meshes features
/// contribute to the deviation; NoiseLevel::agreement distinguishes them: about 0.46 for noise, 0.6 and more for
/// features. Independent of the orientation of triangles. For a cloud the deviation is 0 and the agreement 1.
NoiseLevel noise_level(const Shape& shape, const VertexNeighbours& neighbours, const Welding& welding);

/// Returns true if the vertices of a mesh are clearly noisy: at least 500 used, distinct vertices,
/// NoiseLevel::relative() of at least 0.1, and NoiseLevel::agreement below 0.56 (geometric features: 0.6 and more).
bool is_noisy(const NoiseLevel& noise, const VertexNeighbours& neighbours);

/// Low-pass filters the vertices of a mesh without shrinkage, by alternating Laplacian steps of opposite sign (Taubin
/// 1995, "A signal processing approach to fair surface design").
///
/// `pass_band` is Taubin's k_PB in (0, 1). A component of frequency k (0: constant; 3/2 and more: alternating between
/// vertices) is multiplied by ((1 - k / 2) (1 + k / (2 - pass_band)))^N, with N = ceil(2 / pass_band) + 3 rounds. It is
/// preserved for k < pass_band (to within 2 % for a pass_band of at most 0.1) and attenuated beyond. A wave of n edges
/// has a k of about (pi / n)^2. Vertices without neighbours stay. Throws InputError for a pass band out of range.
Points taubin_smoothing(const Points& vertices, const VertexNeighbours& neighbours, double pass_band);

/// Result of denoised().
struct DenoisedShape {
  Shape shape;           ///< smoothed shape, or the input shape if it was not clearly noisy
  NoiseLevel noise;      ///< noise of the input shape
  double pass_band = 0;  ///< pass band of the smoothing (taubin_smoothing()); 0 if not smoothed
};

/// Smooths a mesh whose vertices are clearly noisy (is_noisy()), with a pass band of 0.025 / noise.relative() clamped
/// to [0.02, 0.3] (docs/notes/reproducing.md, Fig 6, shows the effect). Duplicate triangles stay duplicates. Returns
/// other meshes and clouds unchanged.
DenoisedShape denoised(Shape shape);

}  // namespace shapegauge
