// SPDX-License-Identifier: GPL-3.0-or-later
// The segmentation of given meshes compared with CGAL's, in one process:
//
//     benchmark_segmentation [options of Google Benchmark] MESH...
//
// Benchmarks are named MESH/method. Times are of one thread and include the SDF. CGAL uses libmaxflow
// (cgal_segmentation.h).
#include <benchmark/benchmark.h>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <tbb/task_arena.h>
#include <vector>

#include "benchmarks/cgal_segmentation.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/segmentation/paper_segmentation.h"
#include "shapegauge/segmentation/part_segmentation.h"

namespace {

using namespace shapegauge;

void segment_as_the_paper(const Shape& shape) {
  const SurfaceGraph graph = surface_graph(shape);
  const std::vector<ScalarField> fields = {{cone_sdf(shape, graph.samples, {}).values, graph.samples.weights}};
  benchmark::DoNotOptimize(paper_segmentation(graph, fields, {}));
}

void add_case(const std::string& name, const Shape& shape, const std::function<void(const Shape&)>& segment) {
  benchmark::RegisterBenchmark(name.c_str(), [&shape, segment](benchmark::State& state) {
    tbb::task_arena one(1);
    for (auto _ : state) one.execute([&] { segment(shape); });
    state.counters["faces"] = static_cast<double>(shape.triangles.rows());
  })->Unit(benchmark::kMillisecond);
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  std::vector<Shape> shapes;
  for (int i = 1; i < argc; ++i) shapes.push_back(read_shape(argv[i]));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string name = std::filesystem::path(argv[i + 1]).stem().string();
    add_case(name + "/best", shapes[i],
             [](const Shape& shape) { benchmark::DoNotOptimize(part_segmentation(shape, {})); });
    add_case(name + "/paper", shapes[i], segment_as_the_paper);
    add_case(name + "/cgal", shapes[i],
             [](const Shape& shape) { benchmark::DoNotOptimize(cgal_segmentation(shape, 4, 0.1)); });
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "benchmark_segmentation: error: " << error.what() << '\n';
    return 2;
  }
}
