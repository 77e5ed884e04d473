#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// To be raised with every change of d2() that changes a value.
inline constexpr int d2_version = 2;

/// Settings of d2().
struct D2Options {
  int points = 1024;   ///< places on the surface, all pairs of which count
  int bins = 64;       ///< from distance 0 to `longest`
  double longest = 3;  ///< the last bin's end, in mean distances; greater ones count in the last bin
};

/// The shape distribution D2 (Osada, Funkhouser, Chazelle, Dobkin 2002): the histogram of the distances between pairs
/// of places spread over the surface by area, divided by their mean, normalised to sum 1. Rotation, scale and mesh do
/// not matter; clouds are described by their points. Compared by L1, the better of the norms in the paper.
///
/// The sphere's density of distances d is d / (2 R^2) from 0 to 2 R, its mean 4 R / 3. Throws InputError for options
/// out of range, an unusable shape, and one without two places.
Eigen::VectorXf d2(const Shape& shape, const D2Options& options = {});

Descriptor d2_descriptor();

}  // namespace shapegauge
