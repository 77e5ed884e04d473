#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/shape/unit_frame.h"
#include "shapegauge/core/spatial/surface_tree.h"

namespace shapegauge {

/// A mesh whose triangles' normals are taken for the truth.
class TrueNormals {
 public:
  /// Throws std::invalid_argument for a point cloud.
  explicit TrueNormals(const Shape& mesh);

  /// The unit normal, by its corners' order, of the triangle nearest to the point; zero where that has no area.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const;

 private:
  UnitFrame frame_;
  SurfaceTree tree_;
};

/// Angles between normals and the truth, in degrees, each weighted by the area of its sample.
struct NormalErrors {
  double mean = 0;
  double median = 0;
  double percentile_90 = 0;
};

/// The errors of the unit normals at the points. Zero normals do not count, nor do weights of zero; all is NaN where
/// nothing counts. sided: whether a normal that points the other way is wrong by 180 degrees; otherwise it is right.
/// Runs in the calling TBB arena.
NormalErrors normal_errors(const TrueNormals& truth, const Points& points, const Points& normals,
                           const Eigen::VectorXd& weights, bool sided);

}  // namespace shapegauge
