#pragma once

#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Raised with every change of what diagnose() finds, which makes cached results of earlier versions stale.
inline constexpr int diagnostics_version = 2;

/// Defects and properties of a shape before it is measured. For edges and components, vertices at exactly the same
/// place are one vertex, and a triangle whose corners are not at three places has no edges. Doubled triangles are
/// counted, and play no further part (distinct_triangles()). Nothing depends on the order of vertices and triangles.
struct ShapeDiagnostics {
  std::size_t vertices = 0;
  std::size_t unreferenced_vertices = 0;  ///< of a mesh: vertices that no triangle uses
  std::size_t coincident_vertices = 0;    ///< vertices at the place of an earlier one
  double diagonal = 0;                    ///< of the bounding box

  std::size_t triangles = 0;
  double area = 0;
  std::size_t degenerate_triangles = 0;  ///< without area, to within the rounding of coordinates
  std::size_t duplicate_triangles = 0;   ///< with the same corners as an earlier one, in any order
  std::size_t components = 0;            ///< of a mesh: parts connected through vertices

  bool watertight = false;  ///< every edge has an even number of triangles (is_watertight())
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;      ///< with one triangle
  double boundary_length = 0;          ///< the sum of their lengths, in the shape's units
  std::size_t non_manifold_edges = 0;  ///< with more than two triangles
  std::size_t inconsistent_edges = 0;  ///< with two triangles of opposite orientation

  double gap_size = 0;         ///< the offset that closes the gaps (gap_size()), in the shape's units
  double point_spacing = 0;    ///< of a cloud (point_spacing()), in the shape's units
  double noise_deviation = 0;  ///< of a mesh: standard deviation of the noise (NoiseLevel), in the shape's units
  bool noisy = false;          ///< whether that is noise beyond doubt (is_noisy())
};

/// Diagnoses a mesh or a cloud; all zero for an empty shape. Throws InputError for an unusable shape
/// (require_usable()).
ShapeDiagnostics diagnose(const Shape& shape);

/// The volume that a watertight, consistently oriented mesh encloses; negative where its triangles face inward. Of
/// doubled triangles the first counts.
double signed_volume(const Shape& shape);

}  // namespace shapegauge
