// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/proxy/dense_samples.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

/// Local connectivity of the samples of a surface, where triangles do not tell: of a cloud, and between components of a
/// mesh. A sample is connected to those of its 8 nearest neighbours that are on the same sheet. At the crease between
/// two parts that touch, samples of one face those of the other and are not connected.
class SampleConnectivity {
 public:
  explicit SampleConnectivity(const DenseSamples& samples);

  /// Returns true if a path connects two samples through samples in the ball about `centre`, the midpoint of the two,
  /// that is 1.5 times as large as the one with both on its boundary: samples are sparse.
  bool connected_in_ball(std::int32_t from, std::int32_t to, const Eigen::Vector3d& centre, double distance);

 private:
  const DenseSamples& samples_;
  PointNeighbours nearest_;
  std::vector<std::int32_t> visited_by_;  ///< per sample: number of the last search that visited it
  std::vector<std::int32_t> queue_;       ///< samples in the order of visits
  std::int32_t search_ = 0;
};

}  // namespace shapegauge
