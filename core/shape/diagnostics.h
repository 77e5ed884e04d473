#pragma once

#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// To be raised with every change of what diagnose() finds: what a cache holds of earlier versions is then found anew.
inline constexpr int diagnostics_version = 1;

/// What there is to know of a shape before measuring it. Vertices at exactly the same place are one vertex for all that
/// concerns edges and components, and a triangle whose corners are not at three places has no edges. Nothing here
/// depends on the order of vertices and triangles.
struct ShapeDiagnostics {
  std::size_t vertices = 0;
  std::size_t unreferenced_vertices = 0;  ///< of a mesh: vertices that no triangle uses
  std::size_t coincident_vertices = 0;    ///< vertices at the place of another one, but for one at each place
  double diagonal = 0;                    ///< of the bounding box

  std::size_t triangles = 0;
  double area = 0;
  std::size_t degenerate_triangles = 0;  ///< those without area, as far as the rounding of coordinates tells
  std::size_t duplicate_triangles = 0;   ///< those whose corners are another's, in any order, but for one of each
  std::size_t components = 0;            ///< of a mesh: parts that are not connected through vertices

  bool closed = false;  ///< whether every edge has an even number of triangles (is_watertight)
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;      ///< those of one triangle
  double boundary_length = 0;          ///< their lengths' sum, in the shape's units
  std::size_t non_manifold_edges = 0;  ///< those of more than two triangles
  std::size_t inconsistent_edges = 0;  ///< those of two triangles that are not oriented alike

  double gap_size = 0;         ///< what an offset must exceed to close the gaps (gap_size()), in the shape's units
  double point_spacing = 0;    ///< of a cloud (point_spacing()), in the shape's units
  double noise_deviation = 0;  ///< of a mesh: what neighbours do not share (NoiseLevel), in the shape's units
  bool noisy = false;          ///< whether that is noise beyond doubt (is_noisy)
};

/// Diagnoses a mesh or a cloud; of an empty shape everything is 0. Throws InputError where the shape is unusable
/// (validity.h).
ShapeDiagnostics diagnose(const Shape& shape);

}  // namespace shapegauge
