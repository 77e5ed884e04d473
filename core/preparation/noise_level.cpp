#include "shapegauge/core/preparation/noise_level.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "shapegauge/core/preparation/taubin_smoothing.h"
#include "shapegauge/core/shape/merged_vertices.h"

namespace shapegauge {

namespace {

/// The directions along which the triangles about each vertex face, whichever way round each is oriented. Vertices at
/// the same place have the same.
Points unsigned_normals(const Points& vertices, const Triangles& triangles) {
  const std::vector<std::int32_t> merged = merged_by_place(vertices);
  const auto place_of = [&](Eigen::Index vertex) {
    return static_cast<std::size_t>(merged[static_cast<std::size_t>(vertex)]);
  };
  std::vector<Eigen::Matrix3d> spread(static_cast<std::size_t>(vertices.rows()), Eigen::Matrix3d::Zero());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Eigen::Vector3d a = vertices.row(triangles(f, 0));
    const Eigen::Vector3d b = vertices.row(triangles(f, 1));
    const Eigen::Vector3d c = vertices.row(triangles(f, 2));
    const Eigen::Vector3d cross = (b - a).cross(c - a);
    const double length = cross.norm();
    if (!(length > 0)) continue;
    const Eigen::Matrix3d outer = cross * cross.transpose() / length;
    for (int k = 0; k < 3; ++k) spread[place_of(triangles(f, k))] += outer;
  }
  Points normals = Points::Zero(vertices.rows(), 3);
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    const Eigen::Matrix3d& matrix = spread[place_of(v)];
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

/// The number of places that have neighbours.
std::ptrdiff_t count_places(const VertexNeighbours& neighbours) {
  std::vector<bool> has_neighbours(neighbours.first.size());
  for (const std::int32_t u : neighbours.neighbours) has_neighbours[static_cast<std::size_t>(u)] = true;
  return std::ranges::count(has_neighbours, true);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Heights of the vertices above the smoothed mesh along its normals.
struct Heights {
  Points offsets;
  Points normals;

  [[nodiscard]] double of(Eigen::Index vertex) const { return offsets.row(vertex).dot(normals.row(vertex)); }
};

/// The height of each vertex that has neighbours, less their mean height, scaled so that independent heights of
/// standard deviation 1 give values of standard deviation 1; sizes only.
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
      const double alike = heights.normals.row(v).dot(heights.normals.row(u)) < 0 ? -1 : 1;
      if (alike * heights.of(v) * heights.of(u) > 0) ++same;
    }
  }
  return neighbours.neighbours.empty() ? 1
                                       : static_cast<double>(same) / static_cast<double>(neighbours.neighbours.size());
}

}  // namespace

NoiseLevel noise_level(const Shape& shape, const VertexNeighbours& neighbours) {
  constexpr double pass_band = 0.1;
  constexpr double deviation_of_median = 1.4826;  // of the size of a normally distributed value
  const Points smoothed = taubin_smoothed(shape.vertices, neighbours, pass_band);
  const Heights heights{shape.vertices - smoothed, unsigned_normals(smoothed, shape.triangles)};
  return {.deviation = deviation_of_median * median(unshared_heights(heights, neighbours)),
          .edge_length = mean_edge_length(smoothed, neighbours),
          .agreement = agreement_of(heights, neighbours)};
}

bool is_noisy(const NoiseLevel& noise, const VertexNeighbours& neighbours) {
  constexpr std::ptrdiff_t fewest_vertices = 500;
  constexpr double least_relative = 0.1;
  constexpr double agreement_of_form = 0.56;
  return count_places(neighbours) >= fewest_vertices && noise.relative() >= least_relative &&
         noise.agreement < agreement_of_form;
}

}  // namespace shapegauge
