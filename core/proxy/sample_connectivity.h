// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/proxy/dense_samples.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

/// Local connectivity of the samples of a surface, used where triangles give none: in a cloud, and between components
/// of a mesh. A sample is connected to each of its 8 nearest neighbours that is on the same sheet. At the crease
/// between two touching parts, the samples of the two parts face each other and are not connected.
class SampleConnectivity {
 public:
  explicit SampleConnectivity(const DenseSamples& samples);

  /// Returns true if a path connects two samples through samples in a ball about their midpoint `centre`. `distance` is
  /// the distance between the two samples. The radius of the ball is 0.75 `distance`, and not half: samples are sparse.
  bool connected_in_ball(std::int32_t from, std::int32_t to, const Eigen::Vector3d& centre, double distance);

 private:
  const DenseSamples& samples_;
  PointNeighbours nearest_;               ///< up to 8 nearest neighbours of each sample
  std::vector<std::int32_t> visited_by_;  ///< per sample: number of the last search that visited it
  std::vector<std::int32_t> queue_;       ///< samples in the order of visits
  std::int32_t search_ = 0;               ///< number of the last search, from 1 on
};

}  // namespace shapegauge
