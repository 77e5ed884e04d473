// SPDX-License-Identifier: GPL-3.0-or-later
// A small fixed case, for counting instructions (scripts/benchmark does, under callgrind): the SDF of the offset
// surface of three spheres that overlap, with the crevices between them, at 1 and 5 % of the diagonal.

#include <cstdio>

#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/support/test_shapes.h"

int main() {
  using namespace shapegauge;
  std::vector<Shape> spheres;
  for (const double x : {0.0, 1.2, 2.1}) {
    Shape sphere = test::sphere(1, 3);
    sphere.vertices.col(0).array() += x;
    sphere.vertices.col(1).array() += x * x / 3;
    spheres.push_back(std::move(sphere));
  }
  const Shape shape = test::joined(spheres);
  const Samples samples = sample_shape(shape, SampleSite::faces);
  const OffsetSdfSolver solver(shape);
  double sum = 0;
  for (const double offset : {0.01, 0.05})
    sum += solver.solve(samples, {.offset = offset, .parallel = false}).values.sum();
  std::printf("%.6f\n", sum);
  return 0;
}
