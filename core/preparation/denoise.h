#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Vertex adjacency: for every vertex the vertices that it shares an edge with, each once, in ascending order. Vertices
/// at the same place are merged: they have the same neighbours, and of neighbours at the same place only the first is
/// listed. Vertices that only doubled triangles use have none (distinct_triangles()).
struct VertexNeighbours {
  std::vector<std::size_t> first;        ///< by vertex, where its neighbours begin; one more entry at the end
  std::vector<std::int32_t> neighbours;  ///< all, vertex by vertex

  [[nodiscard]] std::span<const std::int32_t> of(Eigen::Index vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(neighbours).subspan(first[v], first[v + 1] - first[v]);
  }
};

/// The neighbours of a shape's vertices; none without triangles. Throws InputError for an unusable shape
/// (require_usable()).
VertexNeighbours vertex_neighbours(const Shape& shape);

/// How noisy the vertices of a mesh are.
struct NoiseLevel {
  double deviation = 0;    ///< standard deviation along the normal, in the shape's units
  double edge_length = 0;  ///< mean edge length of the smoothed mesh
  /// Fraction of edges whose ends lie on the same side of the smoothed mesh: about 0.46 where heights are independent,
  /// 0.6 and more where they are form (ridges, creases, coarse curved parts).
  double agreement = 1;

  /// deviation / edge_length; 0.02 to 0.05 on clean, fine meshes.
  [[nodiscard]] double relative() const { return edge_length > 0 ? deviation / edge_length : 0; }
};

/// Estimates the noise of a mesh: what moves its vertices along the normal independently of one another.
///
/// The standard deviation is estimated from the median absolute difference between a vertex's height above the smoothed
/// mesh and the mean height of its neighbours, which ignores slow variation and outliers. On coarse meshes form counts
/// as deviation too; `agreement` tells the two apart. The orientation of triangles plays no part. All zero for a cloud.
NoiseLevel noise_level(const Shape& shape, const VertexNeighbours& neighbours);

/// Whether the vertices are noisy beyond doubt: at least 500 of them (coincident ones counted once, unused ones not at
/// all), a relative() of 0.1 or more, and an agreement below 0.56, which form does not have.
bool is_noisy(const NoiseLevel& noise, const VertexNeighbours& neighbours);

/// Low-pass filter of a mesh's vertices without shrinkage: steps towards the mean of the neighbours alternate with
/// slightly larger steps away from it (Taubin 1995, "A signal processing approach to fair surface design").
///
/// pass_band, Taubin's k_PB in (0, 1): what varies along the mesh with a frequency k (0: constant; 3/2 and more: from
/// vertex to vertex) is multiplied by ((1 - k / 2) (1 + k / (2 - pass_band)))^N, with N = ceil(2 / pass_band) + 3
/// rounds: kept for k < pass_band (to within 2 % where pass_band is at most 0.1), faded beyond. A wave of n edges has k
/// of about (pi / n)^2. Vertices without neighbours stay. Throws InputError for a pass band out of range.
Points taubin_smoothed(const Points& vertices, const VertexNeighbours& neighbours, double pass_band);

/// The result of denoised().
struct DenoisedShape {
  Shape shape;
  NoiseLevel noise;      ///< of the shape given
  double pass_band = 0;  ///< of the smoothing (see taubin_smoothed); 0: none, the shape is as given
};

/// Smooths a mesh whose vertices are noisy beyond doubt (is_noisy()), with a pass band of 0.025 / noise.relative(),
/// clamped to 0.02 to 0.3 (docs/notes/figures.md, Fig 6, shows the effect). Doubled triangles stay doubled. Other
/// meshes and clouds are returned unchanged.
DenoisedShape denoised(Shape shape);

}  // namespace shapegauge
