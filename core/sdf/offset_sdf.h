// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of offset_sdf(); see docs/manual/cache.md.
inline constexpr int offset_sdf_version = 13;

/// Resolution of the grid of the offset SDF: cells of edge r/2.5, r/3 or r/5, where r is the offset distance
/// (docs/methods/offset_sdf.md#guarantees).
enum class OffsetAccuracy { fast, standard, fine };
template <>
inline constexpr std::array<std::string_view, 3> words_of<OffsetAccuracy>{"fast", "standard", "fine"};

/// Options of offset_sdf(), the SDF (shape diameter function) of the offset surface.
struct OffsetSdfOptions {
  static constexpr Bounds offset_bounds{.low = 1e-6, .high = 1};  ///< valid range of `offset`

  double offset = 0.05;                                ///< offset distance r as a fraction of the bounding-box diagonal
  OffsetAccuracy accuracy = OffsetAccuracy::standard;  ///< resolution of the grid
  bool parallel = true;  ///< distribute the work over the threads of the calling TBB arena
};

/// Names, bounds and help texts of the parameters in OffsetSdfOptions (option_parameters.h).
inline constexpr std::array offset_sdf_table = {
    with_unit(bounding_box_diagonals,
              option_of<&OffsetSdfOptions::offset>("offset", OffsetSdfOptions::offset_bounds, "Offset distance.")),
    option_of<&OffsetSdfOptions::accuracy>("accuracy", "Resolution of the grid: cells of edge offset / 2.5, 3 or 5."),
};

/// Sample counts by outcome of offset_sdf(). For a sample p with normal n, q is the closest point of the exterior E(r).
struct OffsetSdfOutcomes {
  std::size_t total = 0;      ///< number of all samples
  std::size_t direct = 0;     ///< the closest exterior point q is p + r n or p - r n (n the normal at the sample p)
  std::size_t searched = 0;   ///< q was found by search: p + r n and p - r n are inside the offset solid
  std::size_t undecided = 0;  ///< the search for q did not converge: q may be too far by a cell or two
  std::size_t missing = 0;    ///< no value: p is not on the surface, as a vertex that no triangle uses
  std::size_t two_sided = 0;  ///< the shape is not closed and the SDF is below r / 2: both sides are probably exterior
  std::size_t enlarged = 0;   ///< computed with a larger offset than requested: all samples of a shape, or none
};

/// Result of offset_sdf(), one entry per sample p. q is the exterior point closest to p, and q' the point where the ray
/// from q through p enters the exterior again.
struct OffsetSdfResult {
  Eigen::VectorXd values;  ///< SDF |qq'| - 2r, never negative, in the shape's units; NaN if missing
  Points normals;          ///< outward unit normals, estimated as (q - p)/|q - p|; zero if missing
  OffsetSdfOutcomes outcomes;
  double offset =
      0;  ///< offset used, in bounding-box diagonals: as requested, or the next larger one that fits into memory
  double build_seconds = 0;  ///< time for the construction of the grid: surface, flood fill and sites
  double query_seconds = 0;  ///< time for the queries of all samples
};

/// Computes SDFs of one shape for several offsets, in coordinates shared by all of them. Keeps no reference to the
/// shape. Thread-safe.
class OffsetSdfSolver {
 public:
  /// Accepts meshes and point clouds. Throws InputError if the shape is unusable (require_usable()) or has no extent.
  explicit OffsetSdfSolver(const Shape& shape);

  /// Computes the SDF of the offset surface at samples of the shape (the paper, Algorithm 1;
  /// docs/reference/definitions.md#offset-sdf). Throws InputError for an offset out of range. The result's
  /// build_seconds exclude the constructor.
  [[nodiscard]] OffsetSdfResult solve(const Samples& samples, const OffsetSdfOptions& options) const;

  /// Returns the seconds that the constructor took.
  [[nodiscard]] double build_seconds() const { return build_seconds_; }

 private:
  [[nodiscard]] std::vector<std::int32_t> triangles_of(const Samples& samples) const;

  double build_seconds_ = 0;
  UnitFrame frame_;
  DistinctTriangles mesh_;  ///< distinct triangles of the shape, in the coordinates of frame_
  bool closed_ = false;
};

/// Computes the SDF for one offset. The result's build_seconds include the construction of the solver.
OffsetSdfResult offset_sdf(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options);

}  // namespace shapegauge
