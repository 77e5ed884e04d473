// The SDF of the offset surface on a torus of 18,000 triangles, at the faces, on one thread. The times include building
// the spatial structures.
#include <benchmark/benchmark.h>

#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/core/test_shapes.h"

namespace {

/// The argument is the offset in thousandths of the bounding-box diagonal.
void run_offset_sdf(benchmark::State& state) {
  const shapegauge::Shape shape = shapegauge::test_shapes::torus(1, 0.3, 150, 60);
  const shapegauge::Samples samples = shapegauge::sample_shape(shape, shapegauge::SampleSite::faces);
  const shapegauge::OffsetSdfOptions options{.offset = 0.001 * static_cast<double>(state.range(0)), .parallel = false};
  for ([[maybe_unused]] const auto iteration : state) {
    benchmark::DoNotOptimize(shapegauge::offset_sdf(shape, samples, options));
  }
  state.counters["faces"] = static_cast<double>(samples.points.rows());
}
BENCHMARK(run_offset_sdf)->Name("offset_sdf/torus")->Arg(10)->Arg(30)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
