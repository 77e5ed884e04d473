// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements of the offset SDF in docs/methods/offset_sdf.md and docs/notes/performance.md, in addition to
// scripts/benchmark's tables:
//
//   measure_offset times|threads|turned [--cut N] [--offsets 0.05,0.03,0.01] MESH...
//
// times: processor seconds of one thread, and how many times as long the cone takes; threads: wall-clock seconds on one
// and on two; turned: how many values change with the mesh's direction, the grid and a little noise. --cut N cuts every
// face into four, N times over.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/offset/offset_solver.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

namespace {

struct Settings {
  std::string what;
  int cut = 0;
  std::vector<double> offsets{0.05, 0.03, 0.01};
  std::vector<std::string> meshes;
};

/// A mesh of diagonal 1 and its faces.
struct Case {
  std::string name;
  Shape shape;
  Samples faces;
};

Shape cut_in_four(const Shape& shape) {
  std::map<std::pair<int, int>, int> middles;
  std::vector<Eigen::RowVector3d> vertices;
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) vertices.emplace_back(shape.vertices.row(v));
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
    if (is_new) vertices.emplace_back((shape.vertices.row(a) + shape.vertices.row(b)) / 2);
    return found->second;
  };
  Shape result;
  result.triangles.resize(4 * shape.triangles.rows(), 3);
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::RowVector3i t = shape.triangles.row(f);
    const int ab = middle(t[0], t[1]);
    const int bc = middle(t[1], t[2]);
    const int ca = middle(t[2], t[0]);
    result.triangles.middleRows<4>(4 * f) << t[0], ab, ca, ab, t[1], bc, ca, bc, t[2], ab, bc, ca;
  }
  result.vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) result.vertices.row(static_cast<Eigen::Index>(v)) = vertices[v];
  return result;
}

Case read_case(const std::string& path, int cut) {
  Shape shape = read_shape(path);
  for (int i = 0; i < cut; ++i) shape = cut_in_four(shape);
  shape = in_unit_frame(shape, unit_frame(shape));
  Samples faces = sample_shape(shape, SampleSite::faces);
  return {path.substr(path.rfind('/') + 1), std::move(shape), std::move(faces)};
}

OffsetResults answers(const Shape& shape, const Points& points, const Points& normals, double offset,
                      double cells_per_offset = 3, bool parallel = false) {
  return solve_on_grid(shape, points, normals,
                       {.offset = offset, .cells_per_offset = cells_per_offset, .parallel = parallel});
}

double processor_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double wall_clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Minimum of up to five runs, or of two if they are long.
template <typename Clock, typename Task>
double min_seconds(const Clock& clock, const Task& task) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 2 || (run < 5 && least < 0.5); ++run) {
    const double start = clock();
    task();
    least = std::min(least, clock() - start);
  }
  return least;
}

void measure_times(const Case& one, const Settings& settings) {
  const double cone = min_seconds(processor_seconds, [&] { cone_sdf(one.shape, one.faces, {.parallel = false}); });
  fmt::print("| {} | {} | {:.1f} |", one.name, one.faces.points.rows(), 1e3 * cone);
  for (const double offset : settings.offsets) {
    OffsetResults found;
    const double seconds = min_seconds(
        processor_seconds, [&] { found = answers(one.shape, one.faces.points, one.faces.normals, offset); });
    const auto undecided = std::count(found.outcomes.begin(), found.outcomes.end(), OffsetOutcome::undecided);
    fmt::print(" {:.1f} ({:.2f}), {} undecided |", 1e3 * seconds, cone / seconds, undecided);
  }
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  fmt::print(" peak {} MB\n", usage.ru_maxrss / 1024);
}

void measure_threads(const Case& one, const Settings& settings) {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  fmt::print("| {} | {} |", one.name, one.faces.points.rows());
  for (const double offset : settings.offsets) {
    std::array<double, 2> seconds;
    for (const bool parallel : {false, true}) {
      seconds[parallel ? 1 : 0] = min_seconds(
          wall_clock_seconds, [&] { answers(one.shape, one.faces.points, one.faces.normals, offset, 3, parallel); });
    }
    fmt::print(" {:.1f} / {:.1f} = {:.2f} |", 1e3 * seconds[0], 1e3 * seconds[1], seconds[0] / seconds[1]);
  }
  fmt::print("\n");
}

/// Percentages of values that differ by more than 1 % and 10 % of r.
std::string difference(const OffsetResults& a, const OffsetResults& b, double offset) {
  const Eigen::ArrayXd change = (a.values - b.values).array().abs() / offset;
  const auto percent = [&](double limit) {
    return 100.0 * static_cast<double>((change > limit).count()) / static_cast<double>(change.size());
  };
  return fmt::format("{:.2f} ({:.2f})", percent(0.01), percent(0.1));
}

void measure_turned(const Case& one, const Settings& settings) {
  const Points& points = one.faces.points;
  const Points& normals = one.faces.normals;
  const Eigen::Matrix3d back = Eigen::Quaterniond(0.3, 0.5, -0.2, 0.7).normalized().toRotationMatrix().transpose();
  const Shape turned{one.shape.vertices * back, one.shape.triangles};
  Shape noisy = one.shape;
  RandomNumbers random(1);
  for (double& coordinate : noisy.vertices.reshaped()) coordinate += random.uniform(-1e-3, 1e-3);
  const Samples noisy_faces = sample_shape(noisy, SampleSite::faces);
  for (const double offset : settings.offsets) {
    const OffsetResults found = answers(one.shape, points, normals, offset);
    fmt::print("| {}, {:g} % | turned {} | cells half as large {} | 0.1 % noise {} |\n", one.name, 100 * offset,
               difference(found, answers(turned, points * back, normals * back, offset), offset),
               difference(found, answers(one.shape, points, normals, offset, 6), offset),
               difference(found, answers(noisy, noisy_faces.points, noisy_faces.normals, offset), offset));
  }
}

Settings parse(const std::vector<std::string>& arguments) {
  Settings settings;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto value = [&] { return i + 1 < arguments.size() ? arguments[++i] : throw ArgumentError("value"); };
    if (arguments[i] == "--cut") {
      settings.cut = std::stoi(value());
    } else if (arguments[i] == "--offsets") {
      settings.offsets.clear();
      const std::string list = value();
      for (std::size_t at = 0; at < list.size(); at = std::min(list.find(',', at), list.size() - 1) + 1) {
        settings.offsets.push_back(std::stod(list.substr(at)));
      }
    } else if (settings.what.empty()) {
      settings.what = arguments[i];
    } else {
      settings.meshes.push_back(arguments[i]);
    }
  }
  if (settings.meshes.empty()) throw ArgumentError("arguments");
  return settings;
}

using Measure = void (*)(const Case&, const Settings&);

int run(const std::vector<std::string>& arguments) {
  const Settings settings = parse(arguments);
  const std::map<std::string, Measure> measures{
      {"times", measure_times}, {"threads", measure_threads}, {"turned", measure_turned}};
  const Measure measure = measures.at(settings.what);
  for (const std::string& mesh : settings.meshes) measure(read_case(mesh, settings.cut), settings);
  return 0;
}

}  // namespace

}  // namespace shapegauge

int main(int argc, char** argv) {
  try {
    return shapegauge::run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::logic_error&) {
    fmt::print(stderr, "usage: measure_offset times|threads|turned [--cut N] [--offsets 0.05,0.01] MESH...\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
}
