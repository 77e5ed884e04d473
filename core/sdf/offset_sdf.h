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

/// To be raised with every change of offset_sdf() that changes a value, a normal or an outcome: what a cache holds of
/// earlier versions is then computed anew.
inline constexpr int offset_sdf_version = 9;

/// How fine the grid is (docs/methods/offset_sdf.md#what-is-promised): its cells measure r/2.5, r/3 or r/5.
enum class OffsetAccuracy { fast, standard, fine };
template <>
inline constexpr std::array<std::string_view, 3> words_of<OffsetAccuracy>{"fast", "standard", "fine"};

/// Settings of the SDF of the offset surface.
struct OffsetSdfOptions {
  static constexpr Bounds offset_bounds{.low = 1e-6, .high = 1};

  double offset = 0.05;  ///< r as a fraction of the bounding-box diagonal
  OffsetAccuracy accuracy = OffsetAccuracy::standard;
  bool parallel = true;  ///< spread the work over the threads of the calling TBB arena
};

/// What may be chosen of OffsetSdfOptions.
inline constexpr std::array offset_sdf_table = {
    option_of<&OffsetSdfOptions::offset>("offset", OffsetSdfOptions::offset_bounds,
                                         "Offset distance as a fraction of the bounding box's diagonal."),
    option_of<&OffsetSdfOptions::accuracy>(
        "accuracy", "How fine the grid of the computation is: its cells are the offset over 2.5, 3 or 5."),
};

/// How the samples of one call were answered.
struct OffsetSdfOutcomes {
  std::size_t total = 0;
  std::size_t direct = 0;     ///< q = p + r n, n the normal of the sample's own surface (either side)
  std::size_t searched = 0;   ///< p + r n is covered by another part of the offset solid: q found by search
  std::size_t undecided = 0;  ///< answered, but no refinement settled: q may be too far by a cell or two
  std::size_t missing = 0;    ///< not a point of the surface (a vertex that no triangle uses): no value
  std::size_t enlarged = 0;   ///< answered at a larger offset than asked for: all samples of a shape, or none
};

/// The SDF of the offset surface, sample by sample.
struct OffsetSdfResult {
  Eigen::VectorXd values;  ///< |qq'| - 2r, never negative, in the shape's units; NaN where missing
  Points normals;          ///< (q - p)/|q - p|: the outward normal estimate; zero where missing
  OffsetSdfOutcomes outcomes;
  double offset = 0;  ///< as used: options.offset, or the least above it whose grid fits into memory (offset_solver.h)
  double build_seconds = 0;  ///< the grid: surface, flood and sites
  double query_seconds = 0;  ///< all samples
};

/// A shape in the coordinates that all of its offsets are computed in: make it once, then ask for one offset after the
/// other. Keeps no reference to the shape. Safe to ask from many threads.
class OffsetSdfSolver {
 public:
  /// The shape may be a point cloud. Throws InputError where it is unusable (require_usable()) or has no extent.
  explicit OffsetSdfSolver(const Shape& shape);

  /// SDF of the offset surface at samples of the shape (the paper, Algorithm 1;
  /// docs/reference/definitions.md#offset-sdf). Throws InputError where the offset is out of range. The build's seconds
  /// do not include the constructor's.
  [[nodiscard]] OffsetSdfResult solve(const Samples& samples, const OffsetSdfOptions& options) const;

  /// Seconds that the constructor took.
  [[nodiscard]] double build_seconds() const { return build_seconds_; }

 private:
  [[nodiscard]] std::vector<std::int32_t> triangles_of(const Samples& samples) const;

  double build_seconds_ = 0;
  UnitFrame frame_;
  DistinctTriangles mesh_;  ///< in the frame
};

/// The same for one offset; the build's seconds are those of everything.
OffsetSdfResult offset_sdf(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options);

}  // namespace shapegauge
