#include "tests/oracle/proven_offset_sdf.h"

#include <Eigen/Geometry>

#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

ProvenOffsetSdf::ProvenOffsetSdf(const Shape& shape, double r)
    : r_(r),
      tree_(shape),
      exterior_(tree_, bounding_box(shape), r, is_closed_and_oriented(shape)),
      nearest_(exterior_),
      entry_(exterior_) {}

Eigen::Vector3d ProvenOffsetSdf::q(const Eigen::Vector3d& p, const Eigen::Vector3d& normal,
                                   const std::array<Eigen::Vector3d, 2>& raised) {
  for (const double side : {r_, -r_}) {
    const Eigen::Vector3d x = p + side * normal;
    if (distance(x) >= (1 - 1e-3) * r_ && is_exterior(x)) return x;
  }
  const Eigen::Vector3d above = nearest(raised[0], normal);
  const Eigen::Vector3d below = nearest(raised[1], normal);
  return (above - raised[0]).norm() <= (below - raised[1]).norm() ? above : below;
}

}  // namespace shapegauge
