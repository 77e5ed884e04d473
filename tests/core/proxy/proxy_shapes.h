// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// A flat rectangle in the plane z = 0 with a corner at the origin: a grid of 2 nx x ny triangles.
inline Shape rectangle(double width, double height, int nx, int ny) {
  Shape shape;
  shape.vertices.resize((nx + 1) * (ny + 1), 3);
  shape.triangles.resize(2 * nx * ny, 3);
  const auto vertex = [nx](int x, int y) { return y * (nx + 1) + x; };
  for (int y = 0; y <= ny; ++y) {
    for (int x = 0; x <= nx; ++x) shape.vertices.row(vertex(x, y)) << width * x / nx, height * y / ny, 0;
  }
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      const int cell = y * nx + x;
      shape.triangles.row(2 * cell) << vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1);
      shape.triangles.row(2 * cell + 1) << vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1);
    }
  }
  return shape;
}

/// The shape without a fraction of its triangles, drawn at random.
inline Shape cracked(const Shape& shape, double fraction, std::uint64_t seed) {
  RandomNumbers random(seed);
  Shape result = shape;
  Eigen::Index kept = 0;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    if (random.uniform(0, 1) >= fraction) result.triangles.row(kept++) = shape.triangles.row(f);
  }
  result.triangles.conservativeResize(kept, 3);
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
