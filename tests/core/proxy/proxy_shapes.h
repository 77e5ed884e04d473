// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// The shape without a fraction of its triangles, drawn at random.
inline Shape cracked(const Shape& shape, double fraction, std::uint64_t seed) {
  RandomNumbers random(seed);
  Shape result = shape;
  Eigen::Index remaining = 0;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    if (random.uniform(0, 1) >= fraction) result.triangles.row(remaining++) = shape.triangles.row(f);
  }
  result.triangles.conservativeResize(remaining, 3);
  return result;
}

/// The shape with half of its triangles, drawn at random, turned over.
inline Shape half_flipped(const Shape& shape, std::uint64_t seed) {
  RandomNumbers random(seed);
  Shape result = shape;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    if (random.uniform(0, 1) < 0.5) std::swap(result.triangles(f, 0), result.triangles(f, 1));
  }
  return result;
}

}  // namespace shapegauge::test
