#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

/// To be raised with every change of offset_sdf() that changes a value, a normal or an outcome: what a cache holds of
/// earlier versions is then computed anew.
inline constexpr int offset_sdf_version = 3;

/// Settings of the SDF of the offset surface.
struct OffsetSdfOptions {
  static constexpr Bounds offset_bounds{.low = 1e-6, .high = 1};

  double offset = 0.05;  ///< r as a fraction of the bounding-box diagonal
  bool parallel = true;  ///< spread the samples over the threads of the calling TBB arena
};

/// How the samples of one call were answered.
struct OffsetSdfOutcomes {
  std::size_t total = 0;
  std::size_t direct = 0;     ///< q = p + r n, n the normal of the sample's own surface (either side)
  std::size_t searched = 0;   ///< p + r n is covered by another part of the offset solid: q found by search
  std::size_t undecided = 0;  ///< answered, but free space was taken for enclosed without proof on the way
  std::size_t missing = 0;    ///< not a point of the surface (a vertex that no triangle uses): no value
};

/// The SDF of the offset surface, sample by sample.
struct OffsetSdfResult {
  Eigen::VectorXd values;  ///< |qq'| - 2r, never negative, in the shape's units; NaN where missing
  Points normals;          ///< (q - p)/|q - p|: the outward normal estimate; zero where missing
  OffsetSdfOutcomes outcomes;
  double build_seconds = 0;  ///< spatial structures and the classification of space
  double query_seconds = 0;  ///< all samples
};

/// What all offsets of a shape have in common: build it once, then ask for one offset after the other. Keeps no
/// reference to the shape. Safe to ask from many threads.
class OffsetSdfSolver {
 public:
  /// The shape may be a point cloud. Throws InputError where it is unusable (validity.h) or has no extent.
  explicit OffsetSdfSolver(const Shape& shape);

  /// SDF of the offset surface at samples of the shape (the paper, Algorithm 1; docs/definitions.md#offset-sdf). Throws
  /// InputError where the offset is out of range. The build's seconds do not include the constructor's.
  [[nodiscard]] OffsetSdfResult solve(const Samples& samples, const OffsetSdfOptions& options) const;

  /// Seconds that the constructor took.
  [[nodiscard]] double build_seconds() const { return build_seconds_; }

 private:
  double build_seconds_ = 0;
  UnitFrame frame_;
  Eigen::AlignedBox3d bounds_;  ///< in the frame
  TriangleBVH tree_;            ///< in the frame
  bool is_watertight_ = false;
  bool is_cloud_;
};

/// The same for one offset; the build's seconds are those of everything.
OffsetSdfResult offset_sdf(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options);

}  // namespace shapegauge
