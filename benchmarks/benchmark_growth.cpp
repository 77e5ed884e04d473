// SPDX-License-Identifier: GPL-3.0-or-later
// How the time of the offset SDF grows with the number of faces: a torus with 10,000 to a million of them, at 5 % of
// the diagonal, on one thread. The counters are microseconds and resident bytes per face.

#include <benchmark/benchmark.h>
#include <cmath>
#include <malloc.h>

#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/support/test_shapes.h"

namespace {

using namespace shapegauge;

void offset_sdf_of_torus(benchmark::State& state) {
  const auto faces = static_cast<double>(state.range(0));
  const int around = static_cast<int>(std::lround(std::sqrt(faces)));
  const Shape shape = test::torus(1, 0.3, around, around / 2);
  const Samples samples = sample_shape(shape, SampleSite::faces);
  std::size_t bytes = 0;
  for ([[maybe_unused]] const auto iteration : state) {
    const std::size_t before = mallinfo2().uordblks + mallinfo2().hblkhd;
    const OffsetSdfSolver solver(shape);
    bytes = mallinfo2().uordblks + mallinfo2().hblkhd - before;
    benchmark::DoNotOptimize(solver.solve(samples, {.offset = 0.05, .parallel = false}));
  }
  const auto count = static_cast<double>(shape.triangles.rows());
  state.counters["faces"] = count;
  state.counters["bytes per face"] = static_cast<double>(bytes) / count;
  state.counters["seconds a face"] =
      benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(offset_sdf_of_torus)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
