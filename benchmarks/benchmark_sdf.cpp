// SPDX-License-Identifier: GPL-3.0-or-later
// The SDF of given meshes at all faces by all available methods, in one process:
//
//     benchmark_sdf [options of Google Benchmark] MESH...
//
// Benchmarks are named MESH/method. Unless stated, times are of one thread and include building all structures.
// scripts/benchmark tabulates their ratios.

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/fields/inscribed_ball.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/perturbation/sample_points.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/spatial/ray_caster.h"

namespace {

using namespace shapegauge;

/// A shape with its samples.
struct Input {
  explicit Input(Shape input_shape, SampleSite site)
      : shape(std::move(input_shape)), samples(sample_shape(shape, site)) {}
  Shape shape;
  Samples samples;
};

/// One inward ray per face: a lower bound of the cost of any SDF.
void cast_one_ray_each(const Input& input) {
  const RayCaster caster(input.shape);
  double sum = 0;
  for (Eigen::Index f = 0; f < input.samples.points.rows(); ++f) {
    const std::array skipped{static_cast<std::int32_t>(f)};
    sum += caster.first_hit(input.samples.points.row(f), -input.samples.normals.row(f), skipped).distance;
  }
  benchmark::DoNotOptimize(sum);
}

void measure_cone(const Input& input, ConeSdfEngine engine) {
  ConeSdfOptions options;
  options.engine = engine;
  options.parallel = false;
  benchmark::DoNotOptimize(cone_sdf(input.shape, input.samples, options));
}

void measure_offsets(const Input& input, const std::vector<double>& offsets, bool parallel = false) {
  const OffsetSdfSolver solver(input.shape);
  for (const double offset : offsets) {
    benchmark::DoNotOptimize(solver.solve(input.samples, {.offset = offset, .parallel = parallel}));
  }
}

void measure_inscribed_ball(const Input& input) {
  benchmark::DoNotOptimize(inscribed_ball(input.shape, input.samples, {.parallel = false}));
}

void add(const std::string& name, const std::function<void()>& work) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [work](benchmark::State& state) {
                                 for ([[maybe_unused]] const auto iteration : state) work();
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void add_damaged(const std::string& mesh, const Shape& shape) {
  RandomNumbers random(1);
  const auto cracked = std::make_shared<Input>(remove_faces(shape, 0.15, random), SampleSite::faces);
  const SamplePointsOptions points{.points = shape.triangles.rows()};
  const auto cloud = std::make_shared<Input>(sample_points(shape, points, random), SampleSite::vertices);
  add(mesh + "/offset 5 % cracked", [cracked] { measure_offsets(*cracked, {0.05}); });
  add(mesh + "/offset 5 % cloud", [cloud] { measure_offsets(*cloud, {0.05}); });
}

void add(const std::filesystem::path& path) {
  const std::string mesh = path.stem().string();
  const auto input = std::make_shared<Input>(read_shape(path), SampleSite::faces);
  add(mesh + "/read", [path] { benchmark::DoNotOptimize(read_shape(path)); });
  add(mesh + "/one ray", [input] { cast_one_ray_each(*input); });
  add(mesh + "/cone embree", [input] { measure_cone(*input, ConeSdfEngine::embree); });
  add(mesh + "/cone cgal", [input] { measure_cone(*input, ConeSdfEngine::cgal); });
  add(mesh + "/inscribed ball", [input] { measure_inscribed_ball(*input); });
  add(mesh + "/offset 1 %", [input] { measure_offsets(*input, {0.01}); });
  add(mesh + "/offset 3 %", [input] { measure_offsets(*input, {0.03}); });
  add(mesh + "/offset 5 %", [input] { measure_offsets(*input, {0.05}); });
  add(mesh + "/offsets 1, 3, 5 %", [input] { measure_offsets(*input, {0.01, 0.03, 0.05}); });
  add(mesh + "/offset 5 % two threads",
      [input] { tbb::task_arena(2).execute([&] { measure_offsets(*input, {0.05}, true); }); });
  add_damaged(mesh, input->shape);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc < 2) {
    std::cerr << "usage: benchmark_sdf [options of Google Benchmark] MESH...\n";
    return 2;
  }
  try {
    for (int i = 1; i < argc; ++i) add(std::filesystem::path(argv[i]));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
