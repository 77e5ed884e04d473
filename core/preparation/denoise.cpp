// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/preparation/denoise.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/median.h"
#include "shapegauge/core/shape/distinct_triangles.h"

namespace shapegauge {

namespace {

/// Edge from the viewpoint of one end.
struct Neighbour {
  std::int32_t of;
  std::int32_t vertex;
};

/// Returns the sorted neighbours of each welded vertex; those across edges with two triangles occur twice. Marks the
/// vertices of the distinct triangles as used.
BucketSorted<Neighbour> welded_neighbours(const Triangles& triangles, const Welding& welding, std::vector<bool>& used) {
  const std::vector<std::int32_t>& merged = welding.vertices;
  std::vector<Neighbour> neighbours;
  neighbours.reserve(6 * static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    if (!welding.is_distinct(f)) continue;
    for (int k = 0; k < 3; ++k) {
      used[static_cast<std::size_t>(triangles(f, k))] = true;
      const std::int32_t a = merged[static_cast<std::size_t>(triangles(f, k))];
      const std::int32_t b = merged[static_cast<std::size_t>(triangles(f, (k + 1) % 3))];
      if (a == b) continue;
      neighbours.push_back({a, b});
      neighbours.push_back({b, a});
    }
  }
  BucketSorted<Neighbour> counted = bucket_sort(neighbours, merged.size(), [](const Neighbour& n) { return n.of; });
  for (std::size_t v = 0; v < merged.size(); ++v) {
    const std::span all(counted.values);
    std::ranges::sort(all.subspan(counted.first[v], counted.first[v + 1] - counted.first[v]), {}, &Neighbour::vertex);
  }
  return counted;
}

/// Computes unoriented vertex normals, independent of the triangles' orientation. Welded vertices have the same.
Points unsigned_normals(const Points& vertices, const Triangles& triangles, const Welding& welding) {
  const auto welded_index = [&](Eigen::Index vertex) {
    return static_cast<std::size_t>(welding.vertices[static_cast<std::size_t>(vertex)]);
  };
  std::vector<Eigen::Matrix3d> spread(static_cast<std::size_t>(vertices.rows()), Eigen::Matrix3d::Zero());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    if (!welding.is_distinct(f)) continue;
    const Eigen::Vector3d a = vertices.row(triangles(f, 0));
    const Eigen::Vector3d b = vertices.row(triangles(f, 1));
    const Eigen::Vector3d c = vertices.row(triangles(f, 2));
    const Eigen::Vector3d cross = (b - a).cross(c - a);
    const double length = cross.norm();
    if (!(length > 0)) continue;
    const Eigen::Matrix3d outer = cross * cross.transpose() / length;
    for (int k = 0; k < 3; ++k) spread[welded_index(triangles(f, k))] += outer;
  }
  Points normals = Points::Zero(vertices.rows(), 3);
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    const Eigen::Matrix3d& matrix = spread[welded_index(v)];
    if (matrix.isZero(0)) continue;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(matrix / matrix.trace());
    normals.row(v) = solver.eigenvectors().col(2).transpose();
  }
  return normals;
}

double mean_edge_length(const Points& vertices, const VertexNeighbours& neighbours) {
  double sum = 0;
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    for (const std::int32_t u : neighbours.of(v)) sum += (vertices.row(u) - vertices.row(v)).norm();
  }
  return neighbours.neighbours.empty() ? 0 : sum / static_cast<double>(neighbours.neighbours.size());
}

/// Counts the welded vertices that have neighbours.
std::ptrdiff_t count_positions(const VertexNeighbours& neighbours) {
  std::vector<bool> has_neighbours(neighbours.first.size());
  for (const std::int32_t u : neighbours.neighbours) has_neighbours[static_cast<std::size_t>(u)] = true;
  return std::ranges::count(has_neighbours, true);
}

double median_or_zero(std::vector<double> values) { return values.empty() ? 0 : upper_median(values); }

/// Heights of the vertices above the smoothed mesh along its normals.
struct Heights {
  Points offsets;
  Points normals;

  [[nodiscard]] double of(Eigen::Index vertex) const { return offsets.row(vertex).dot(normals.row(vertex)); }
};

/// Returns the absolute height of each vertex above the mean of its neighbours' heights, scaled to standard deviation 1
/// for independent heights of standard deviation 1.
std::vector<double> unshared_heights(const Heights& heights, const VertexNeighbours& neighbours) {
  std::vector<double> unshared;
  for (Eigen::Index v = 0; v < heights.offsets.rows(); ++v) {
    const auto around = neighbours.of(v);
    if (around.empty()) continue;
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for (const std::int32_t u : around) mean += heights.offsets.row(u);
    const auto count = static_cast<double>(around.size());
    const double height = (heights.offsets.row(v) - mean / count).dot(heights.normals.row(v));
    unshared.push_back(std::abs(height) / std::sqrt(1 + 1 / count));
  }
  return unshared;
}

double agreement_of(const Heights& heights, const VertexNeighbours& neighbours) {
  std::size_t same = 0;
  for (Eigen::Index v = 0; v < heights.offsets.rows(); ++v) {
    for (const std::int32_t u : neighbours.of(v)) {
      const double sign = heights.normals.row(v).dot(heights.normals.row(u)) < 0 ? -1 : 1;
      if (sign * heights.of(v) * heights.of(u) > 0) ++same;
    }
  }
  return neighbours.neighbours.empty() ? 1
                                       : static_cast<double>(same) / static_cast<double>(neighbours.neighbours.size());
}

/// Points with a fourth coordinate of 0, to fill vector registers.
using PaddedPoints = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Moves every vertex by a fraction of the way towards the mean of its neighbours (away from it if negative).
void step(const PaddedPoints& before, const VertexNeighbours& neighbours, double fraction, PaddedPoints& vertices) {
  for (Eigen::Index v = 0; v < before.rows(); ++v) {
    const auto around = neighbours.of(v);
    vertices.row(v) = before.row(v);
    if (around.empty()) continue;
    Eigen::RowVector4d sum = Eigen::RowVector4d::Zero();
    for (const std::int32_t u : around) sum += before.row(u);
    vertices.row(v) += fraction * (sum / static_cast<double>(around.size()) - before.row(v));
  }
}

}  // namespace

VertexNeighbours vertex_neighbours(const Shape& shape, const Welding& welding) {
  const std::vector<std::int32_t>& merged = welding.vertices;
  std::vector<bool> used(merged.size());
  const BucketSorted<Neighbour> sorted = welded_neighbours(shape.triangles, welding, used);
  VertexNeighbours result;
  result.first.reserve(merged.size() + 1);
  result.neighbours.reserve(sorted.values.size() / 2);
  for (std::size_t v = 0; v < merged.size(); ++v) {
    result.first.push_back(result.neighbours.size());
    if (!used[v]) continue;
    const auto welded = static_cast<std::size_t>(merged[v]);
    for (std::size_t i = sorted.first[welded]; i < sorted.first[welded + 1]; ++i) {
      const std::int32_t vertex = sorted.values[i].vertex;
      if (i > sorted.first[welded] && vertex == sorted.values[i - 1].vertex) continue;
      result.neighbours.push_back(vertex);
    }
  }
  result.first.push_back(result.neighbours.size());
  return result;
}

NoiseLevel noise_level(const Shape& shape, const VertexNeighbours& neighbours, const Welding& welding) {
  constexpr double pass_band = 0.1;
  constexpr double deviation_of_median = 1.4826;  // of the size of a normally distributed value
  const Points smoothed = taubin_smoothing(shape.vertices, neighbours, pass_band);
  const Heights heights{shape.vertices - smoothed, unsigned_normals(smoothed, shape.triangles, welding)};
  return {.deviation = deviation_of_median * median_or_zero(unshared_heights(heights, neighbours)),
          .edge_length = mean_edge_length(smoothed, neighbours),
          .agreement = agreement_of(heights, neighbours)};
}

bool is_noisy(const NoiseLevel& noise, const VertexNeighbours& neighbours) {
  constexpr std::ptrdiff_t min_vertices = 500;
  constexpr double min_relative = 0.1;
  constexpr double agreement_of_form = 0.56;
  return count_positions(neighbours) >= min_vertices && noise.relative() >= min_relative &&
         noise.agreement < agreement_of_form;
}

Points taubin_smoothing(const Points& vertices, const VertexNeighbours& neighbours, double pass_band) {
  if (!(pass_band > 0 && pass_band < 1)) {
    throw InputError(fmt::format("the pass band of the smoothing is {}; it must be between 0 and 1", pass_band));
  }
  constexpr double inward = 0.5;
  const double outward = 1 / (pass_band - 1 / inward);  // 1 / inward + 1 / outward = pass_band
  const int rounds = static_cast<int>(std::ceil(2 / pass_band)) + 3;
  PaddedPoints smoothed = PaddedPoints::Zero(vertices.rows(), 4);
  smoothed.leftCols<3>() = vertices;
  PaddedPoints shrunk(vertices.rows(), 4);
  for (int round = 0; round < rounds; ++round) {
    check_interruption();
    step(smoothed, neighbours, inward, shrunk);
    step(shrunk, neighbours, outward, smoothed);
  }
  return smoothed.leftCols<3>();
}

DenoisedShape denoised(Shape shape) {
  require_usable(shape);
  const Welding welding = welding_of(shape);
  const VertexNeighbours neighbours = vertex_neighbours(shape, welding);
  const NoiseLevel noise = noise_level(shape, neighbours, welding);
  DenoisedShape result{.shape = std::move(shape), .noise = noise};
  if (!is_noisy(noise, neighbours)) return result;
  result.pass_band = std::clamp(0.025 / noise.relative(), 0.02, 0.3);
  const Points smoothed = taubin_smoothing(result.shape.vertices, neighbours, result.pass_band);
  result.shape.vertices = smoothed(distinct_triangles(result.shape).vertex_of, Eigen::all);
  return result;
}

}  // namespace shapegauge
