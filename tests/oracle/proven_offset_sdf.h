#pragma once

#include <Eigen/Core>
#include <array>

#include "shapegauge/core/shape/shape.h"
#include "tests/oracle/exterior_entry.h"
#include "tests/oracle/nearest_exterior.h"
#include "tests/oracle/offset_exterior.h"
#include "tests/oracle/surface_tree.h"

namespace shapegauge {

/// The offset SDF (docs/reference/definitions.md#offset-sdf) of a shape with a diagonal of 1, by a search that proves
/// its minimum. Slow, and without a bound on time and memory; for shapes too large for OffsetSdfReference.
class ProvenOffsetSdf {
 public:
  ProvenOffsetSdf(const Shape& shape, double r);

  /// The point of E(r) closest to x, to within 0.008 r. The normal, of length 1 or 0, says where to look first.
  Eigen::Vector3d nearest(const Eigen::Vector3d& x, const Eigen::Vector3d& normal) {
    return nearest_.find(x, normal).point;
  }

  /// q of a sample p with a normal: p + r n or p - r n, where it is exterior, else the point closest to p as raised on
  /// either side, whichever is nearer.
  Eigen::Vector3d q(const Eigen::Vector3d& p, const Eigen::Vector3d& normal,
                    const std::array<Eigen::Vector3d, 2>& raised);

  /// How far from p along the direction E(r) begins.
  double exit(const Eigen::Vector3d& p, const Eigen::Vector3d& direction) { return entry_.find(p, direction).distance; }

  /// d(x).
  [[nodiscard]] double distance(const Eigen::Vector3d& x) const { return tree_.closest(x)->distance; }

  /// Whether x, outside of O(r), belongs to E(r), as far as it can be decided.
  [[nodiscard]] bool is_exterior(const Eigen::Vector3d& x) const { return exterior_.contains(x) != false; }

 private:
  double r_;
  SurfaceTree tree_;
  OffsetExterior exterior_;
  NearestExteriorSearch nearest_;
  ExteriorEntrySearch entry_;
};

}  // namespace shapegauge
