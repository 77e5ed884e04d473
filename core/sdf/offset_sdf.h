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

/// Cache version of offset_sdf(); increment when results change (docs/manual/cache.md).
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
  OffsetAccuracy accuracy = OffsetAccuracy::standard;  ///< resolution of the grid: cells of edge r/2.5, r/3 or r/5
  bool parallel = true;  ///< distribute the work over the threads of the calling TBB arena
};

/// Names, bounds and help texts of the parameters in OffsetSdfOptions (option_parameters.h).
inline constexpr std::array offset_sdf_table = {
    with_unit(bounding_box_diagonals,
              option_of<&OffsetSdfOptions::offset>("offset", OffsetSdfOptions::offset_bounds, "Offset distance.")),
    option_of<&OffsetSdfOptions::accuracy>(
        "accuracy", "Grid resolution: 2.5 (fast), 3 (standard) or 5 (fine) cells per offset distance."),
};

/// Numbers of samples by outcome of offset_sdf(). For a sample p with normal n, q is the closest point of the exterior
/// E(r), the points farther than r from the surface that are connected to infinity.
struct OffsetSdfOutcomes {
  std::size_t total = 0;  ///< number of all samples
  /// Number of samples whose closest exterior point is at the offset distance along the normal, on either side.
  std::size_t direct = 0;
  std::size_t searched = 0;  ///< number of samples whose closest exterior point q was found by iterative search
  /// Number of samples whose search did not converge: the exterior point found may be up to two cells too far.
  std::size_t undecided = 0;
  std::size_t missing = 0;    ///< number of samples without a value: not on the surface, as vertices without triangles
  std::size_t two_sided = 0;  ///< number of samples of an open shape with SDF < r / 2: probably exterior on both sides
  std::size_t enlarged = 0;   ///< number of samples with a value for a larger offset than requested: all or none
};

/// Result of offset_sdf(), one entry per sample p. q is the exterior point closest to p, and q' the point where the ray
/// from q through p enters the exterior again.
struct OffsetSdfResult {
  /// SDF per sample: |qq'| - 2r, never negative, in the shape's units (r: offset distance; q, q': exterior points on
  /// either side of the sample); NaN if missing.
  Eigen::VectorXd values;
  Points normals;  ///< outward unit normal per sample: the direction to its closest exterior point; zero if missing
  OffsetSdfOutcomes outcomes;  ///< numbers of samples by outcome
  double offset =
      0;  ///< offset used, in bounding-box diagonals: as requested, or the next larger one that fits into memory
  double build_seconds = 0;  ///< time for the grid, in seconds: surface points, flood fill and sites
  double query_seconds = 0;  ///< time for the queries of all samples, in seconds
};

/// Computes SDFs of one shape for several offsets, in coordinates shared by all of them. Keeps no reference to the
/// shape. Thread-safe.
class OffsetSdfSolver {
 public:
  /// Accepts meshes and point clouds. Throws InputError if the shape is unusable (require_usable()) or has no extent.
  explicit OffsetSdfSolver(const Shape& shape);

  /// Computes the SDF of the offset surface at samples of the shape (Chen et al. 2018, Algorithm 1;
  /// docs/reference/definitions.md#offset-sdf). Throws InputError for an offset out of range. The result's
  /// build_seconds exclude the constructor.
  [[nodiscard]] OffsetSdfResult solve(const Samples& samples, const OffsetSdfOptions& options) const;

  /// Returns the seconds that the constructor took.
  [[nodiscard]] double build_seconds() const { return build_seconds_; }

 private:
  [[nodiscard]] std::vector<std::int32_t> triangles_of(const Samples& samples) const;

  double build_seconds_ = 0;  ///< time that the constructor took, in seconds
  UnitFrame frame_;           ///< frame of the shape, in whose coordinates SDFs are computed
  DistinctTriangles mesh_;    ///< distinct triangles of the shape, in the coordinates of frame_
  bool closed_ = false;       ///< true if the shape is closed (is_closed())
};

/// Computes the SDF for one offset. The result's build_seconds include the construction of the solver.
OffsetSdfResult offset_sdf(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options);

}  // namespace shapegauge
