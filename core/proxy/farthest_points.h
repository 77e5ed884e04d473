#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/proxy/dense_samples.h"

namespace shapegauge {

/// Samples in farthest-point order, and the samples nearest to each.
struct FarthestPoints {
  std::vector<std::int32_t> chosen;   ///< indices of samples
  std::vector<std::int32_t> nearest;  ///< by sample, the place in `chosen` of the one that covers it
  double covering_radius = 0;         ///< the largest distance of a sample from the chosen one that covers it
};

/// Chooses `count` samples, fewer where there are no more places: first the sample farthest from the centroid, then
/// always the one that is farthest from those chosen (Gonzalez 1985; ties: the first). A chosen sample covers those
/// whose normals agree with its own (normal_agreement() above 0.3): the two sides of a thin wall are sampled each by
/// itself. Samples closer than a tenth of the expected spacing are covered in any case.
FarthestPoints farthest_points(const DenseSamples& samples, Eigen::Index count);

}  // namespace shapegauge
