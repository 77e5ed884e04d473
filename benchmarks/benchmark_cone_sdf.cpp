// The conventional SDF by the embree engine beside CGAL's own, at the faces of given meshes, on one thread:
//
//     benchmark_cone_sdf [options of Google Benchmark] MESH...
//
// The times include building the tree (and, for CGAL, its mesh). Beside them stand the number of faces, how many of
// them have no value, and how many differ between the engines by more than 1e-3 of the diagonal. To compare with other
// figures, use an idle machine and say which mesh; camel.off of CGAL's demo data (19,536 faces) is a usual one.

#include <benchmark/benchmark.h>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/core/sdf/cone_sdf.h"

namespace {

using namespace shapegauge;

struct Input {
  Shape shape;
  Samples samples;
  Eigen::VectorXd reference;  ///< CGAL's values
};

ConeSdfOptions options_for(ConeSdfEngine engine) {
  ConeSdfOptions options;
  options.engine = engine;
  options.parallel = false;
  return options;
}

std::size_t disagreements(const Input& input, const Eigen::VectorXd& values) {
  const double limit = 1e-3 * bounding_box_diagonal(input.shape);
  std::size_t count = 0;
  for (Eigen::Index f = 0; f < values.size(); ++f) {
    const bool both_missing = std::isnan(values[f]) && std::isnan(input.reference[f]);
    if (!both_missing && !(std::abs(values[f] - input.reference[f]) <= limit)) ++count;
  }
  return count;
}

void run(benchmark::State& state, const Input& input, ConeSdfEngine engine) {
  ConeSdfResult result;
  for ([[maybe_unused]] const auto iteration : state) {
    result = cone_sdf(input.shape, input.samples, options_for(engine));
  }
  state.counters["faces"] = static_cast<double>(result.values.size());
  state.counters["missing"] = static_cast<double>(result.missing);
  state.counters["differ"] = static_cast<double>(disagreements(input, result.values));
}

void add(const std::string& path) {
  const auto input = std::make_shared<Input>();
  input->shape = read_shape(path);
  input->samples = sample_shape(input->shape, SampleSite::faces);
  input->reference = cone_sdf(input->shape, input->samples, options_for(ConeSdfEngine::cgal)).values;
  for (const auto& [name, engine] : {std::pair{"embree/", ConeSdfEngine::embree}, {"cgal/", ConeSdfEngine::cgal}}) {
    benchmark::RegisterBenchmark((name + path).c_str(), [input, engine = engine](benchmark::State& state) {
      run(state, *input, engine);
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc < 2) {
    std::cerr << "usage: benchmark_cone_sdf [options of Google Benchmark] MESH...\n";
    return 2;
  }
  try {
    for (int i = 1; i < argc; ++i) add(argv[i]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
