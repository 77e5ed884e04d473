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

/// Resolution of the grid (docs/methods/offset_sdf.md#guarantees): cells of edge r/2.5, r/3 or r/5.
enum class OffsetAccuracy { fast, standard, fine };
template <>
inline constexpr std::array<std::string_view, 3> words_of<OffsetAccuracy>{"fast", "standard", "fine"};

/// Options of the SDF of the offset surface.
struct OffsetSdfOptions {
  static constexpr Bounds offset_bounds{.low = 1e-6, .high = 1};

  double offset = 0.05;  ///< r as a fraction of the bounding-box diagonal
  OffsetAccuracy accuracy = OffsetAccuracy::standard;
  bool parallel = true;  ///< distribute the work over the threads of the calling TBB arena
};

/// Parameters of OffsetSdfOptions.
inline constexpr std::array offset_sdf_table = {
    with_unit(bounding_box_diagonals,
              option_of<&OffsetSdfOptions::offset>("offset", OffsetSdfOptions::offset_bounds, "Offset distance.")),
    option_of<&OffsetSdfOptions::accuracy>("accuracy", "Resolution of the grid: cells of edge offset / 2.5, 3 or 5."),
};

/// Sample counts by outcome.
struct OffsetSdfOutcomes {
  std::size_t total = 0;
  std::size_t direct = 0;     ///< q = p + r n, n the normal of the sample's own surface (either side)
  std::size_t searched = 0;   ///< p + r n is covered by another part of the offset solid: q found by search
  std::size_t undecided = 0;  ///< the search did not converge: q may be too far by a cell or two
  std::size_t missing = 0;    ///< no value, since p is not on the surface: a vertex that no triangle uses
  std::size_t two_sided = 0;  ///< of a shape that is not closed: the exterior is on both sides, closer than half of r
  std::size_t enlarged = 0;   ///< computed with a larger offset than requested: all samples of a shape, or none
};

/// SDF of the offset surface by sample.
struct OffsetSdfResult {
  Eigen::VectorXd values;  ///< |qq'| - 2r, never negative, in the shape's units; NaN if missing
  Points normals;          ///< outward normal estimate (q - p)/|q - p|; zero if missing
  OffsetSdfOutcomes outcomes;
  double offset =
      0;  ///< used offset: the requested one, or the smallest larger one whose grid fits into memory (offset_solver.h)
  double build_seconds = 0;  ///< construction of the grid: surface, flood fill and sites
  double query_seconds = 0;  ///< queries for all samples
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
  DistinctTriangles mesh_;  ///< in the frame
  bool closed_ = false;
};

/// Computes the SDF for one offset. The result's build_seconds include the construction of the solver.
OffsetSdfResult offset_sdf(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options);

}  // namespace shapegauge
