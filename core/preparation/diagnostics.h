// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of diagnose(); see docs/manual/cache.md.
inline constexpr int diagnostics_version = 7;

/// Defects and properties of a shape before it is measured. Edges and components are those of the welded mesh; a
/// triangle with fewer than three distinct corners has no edges. Duplicate triangles are counted and otherwise ignored
/// (distinct_triangles()). Independent of the order of vertices and triangles.
struct ShapeDiagnostics {
  std::size_t vertices = 0;               ///< number of vertices, or of points of a cloud
  std::size_t unreferenced_vertices = 0;  ///< number of vertices of a mesh that no triangle uses
  std::size_t coincident_vertices = 0;    ///< number of vertices that coincide with an earlier one
  double diagonal = 0;                    ///< bounding-box diagonal, in the shape's units

  std::size_t triangles = 0;             ///< number of triangles, including degenerate ones and duplicates
  double area = 0;                       ///< surface_area(), in the shape's units squared; 0 for a cloud
  std::size_t degenerate_triangles = 0;  ///< number of triangles of zero area, up to the rounding of coordinates
  std::size_t duplicate_triangles = 0;   ///< number of triangles with the same corners as an earlier one, in any order
  std::size_t components = 0;            ///< number of components of a mesh, connected through shared vertices

  bool closed = false;                 ///< true if every edge has an even number of triangles (is_closed())
  std::size_t edges = 0;               ///< number of edges
  std::size_t boundary_edges = 0;      ///< number of edges with one triangle
  double boundary_length = 0;          ///< total length of the boundary edges, in the shape's units
  std::size_t non_manifold_edges = 0;  ///< number of edges with more than two triangles
  std::size_t inconsistent_edges = 0;  ///< number of edges with two triangles, of opposite orientations

  double gap_size = 0;         ///< radius of the widest gap (GapSizes), in the shape's units; 0 if `closed`
  double closable_gap = 0;     ///< radius of the widest gap that an automatic offset closes (GapSizes), in shape units
  std::size_t outliers = 0;    ///< number of points of a cloud that are far from all others (outliers())
  bool stray_normals = false;  ///< true if the normals of a cloud are not those of its surface (has_stray_normals())
  double point_spacing = 0;    ///< point spacing of a cloud (point_spacing()), in the shape's units
  double noise_deviation = 0;  ///< of a mesh: standard deviation of the noise (NoiseLevel), in the shape's units
  bool noisy = false;          ///< true if the mesh is clearly noisy (is_noisy())
};

/// Computes the diagnostics of a mesh or a cloud; all zero for an empty shape. Throws InputError for an unusable shape
/// (require_usable()).
ShapeDiagnostics diagnose(const Shape& shape);

/// Computes the volume enclosed by a closed, consistently oriented mesh; negative if its triangles face inwards. In
/// the shape's units cubed. Duplicate triangles count once.
double signed_volume(const Shape& shape);

}  // namespace shapegauge
