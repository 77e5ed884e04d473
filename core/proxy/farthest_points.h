// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/proxy/dense_samples.h"

namespace shapegauge {

/// Samples in farthest-point order and the assignment of all samples to them.
struct FarthestPoints {
  std::vector<std::int32_t> chosen;   ///< indices of the chosen samples, in farthest-point order
  std::vector<std::int32_t> nearest;  ///< per sample: index into `chosen` of the chosen sample that covers it
  double covering_radius = 0;         ///< maximum distance of a sample from the chosen sample that covers it
};

/// Chooses `count` samples, or fewer if there are fewer distinct positions, in farthest-point order (Gonzalez 1985;
/// ties: the first), starting with the sample farthest from the centroid. A chosen sample covers only samples whose
/// normals agree with its own (normal_agreement() above 0.3). The two sides of a thin wall are therefore sampled
/// separately. Samples closer than a tenth of the expected spacing are always covered.
FarthestPoints farthest_points(const DenseSamples& samples, Eigen::Index count);

}  // namespace shapegauge
