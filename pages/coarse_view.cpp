// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/coarse_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

namespace {

/// Cell of a grid, with the octant of a direction.
using Cell = std::array<std::int64_t, 4>;

/// Sums the normals of the faces around each vertex, with twice their areas as lengths.
Points normal_sums(const Shape& mesh) {
  Points sums = Points::Zero(mesh.vertices.rows(), 3);
  for (const auto& face : mesh.triangles.rowwise()) {
    const Eigen::RowVector3d first = mesh.vertices.row(face[0]);
    const Eigen::RowVector3d normal = (mesh.vertices.row(face[1]) - first).cross(mesh.vertices.row(face[2]) - first);
    for (const std::int32_t vertex : face) sums.row(vertex) += normal;
  }
  return sums;
}

/// Merges the vertices in each grid cell whose normals are in the same octant, which separates the sides of thin parts.
/// Drops faces with coincident corners, and all but the first of duplicate faces.
Shape clustered(const Shape& mesh, double side) {
  const Eigen::Vector3d low = bounding_box(mesh).min();
  const Points normals = normal_sums(mesh);
  std::map<Cell, std::int32_t> cells;
  std::vector<std::int32_t> cell_of(static_cast<std::size_t>(mesh.vertices.rows()), -1);
  std::vector<Eigen::Vector4d> sums;  // of the vertices in a cell, and how many
  for (const std::int32_t vertex : mesh.triangles.reshaped<Eigen::RowMajor>()) {
    std::int32_t& cell = cell_of[static_cast<std::size_t>(vertex)];
    if (cell >= 0) continue;
    const Eigen::Vector3d point = mesh.vertices.row(vertex);
    Cell key{};
    for (int k = 0; k < 3; ++k) {
      key[static_cast<std::size_t>(k)] = std::llround(std::floor((point[k] - low[k]) / side));
      key[3] = 2 * key[3] + (normals(vertex, k) < 0 ? 1 : 0);
    }
    cell = cells.emplace(key, static_cast<std::int32_t>(sums.size())).first->second;
    if (cell == static_cast<std::int32_t>(sums.size())) sums.emplace_back(Eigen::Vector4d::Zero());
    sums[static_cast<std::size_t>(cell)] += point.homogeneous();
  }
  Shape result;
  result.vertices.resize(std::ssize(sums), 3);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    result.vertices.row(static_cast<Eigen::Index>(i)) = sums[i].hnormalized().transpose();
  }
  std::set<std::array<std::int32_t, 3>> known;
  std::vector<std::int32_t> corners;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    std::array<std::int32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      face[k] = cell_of[static_cast<std::size_t>(mesh.triangles(f, static_cast<Eigen::Index>(k)))];
    }
    std::array<std::int32_t, 3> sorted = face;
    std::ranges::sort(sorted);
    if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !known.insert(sorted).second) continue;
    corners.insert(corners.end(), face.begin(), face.end());
  }
  result.triangles = Eigen::Map<const Triangles>(corners.data(), std::ssize(corners) / 3, 3);
  return result;
}

/// Returns the cell size for which a mesh of that area gets about `faces` faces: a surface meets about 1.5 cells for
/// each square of their side, and each vertex corresponds to two faces. Limited for tangles of large faces, whose area
/// does not measure their extent.
double side_for(const Shape& mesh, Eigen::Index faces) {
  const double diagonal = bounding_box_diagonal(mesh);
  return std::clamp(std::sqrt(3 * surface_area(mesh) / static_cast<double>(faces)), 1e-6 * diagonal, diagonal / 16);
}

Shape largest_faces(const Shape& mesh, Eigen::Index faces) {
  const Eigen::VectorXd areas = sample_shape(mesh, SampleSite::faces).weights;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(areas.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater{}, [&](Eigen::Index face) { return areas[face]; });
  order.resize(static_cast<std::size_t>(faces));
  std::ranges::sort(order);
  return {.vertices = mesh.vertices, .triangles = mesh.triangles(order, Eigen::all)};
}

Shape coarse_mesh(const Shape& mesh, Eigen::Index faces) {
  // Edge collapses preserve the shape best, but take about 40 times as long as a grid; they start from slightly too
  // many faces.
  constexpr Eigen::Index enough = 5;
  Shape coarse = mesh.triangles.rows() > 2 * enough * faces ? clustered(mesh, side_for(mesh, enough * faces)) : mesh;
  try {
    coarse = decimate(coarse, faces);
  } catch (const InputError&) {
    // No edge can be collapsed: only the grid is used.
  }
  const Shape collapsed = coarse;
  for (double side = side_for(collapsed, faces); coarse.triangles.rows() > faces; side *= 1.25) {
    coarse = clustered(collapsed, side);
  }
  return coarse.triangles.rows() > 0 ? coarse : largest_faces(collapsed, faces);
}

/// Returns, for each sample, the first of the four nearest ones whose normal does not point the opposite way.
std::vector<std::int32_t> nearest_samples(const Samples& samples, const Samples& among) {
  const PointNeighbours found = nearest_among(samples.points, among.points, 4);
  std::vector<std::int32_t> nearest;
  nearest.reserve(static_cast<std::size_t>(samples.points.rows()));
  for (Eigen::Index row = 0; row < samples.points.rows(); ++row) {
    const auto candidates = found.indices.row(row);
    const auto facing = std::ranges::find_if(
        candidates, [&](std::int32_t other) { return samples.normals.row(row).dot(among.normals.row(other)) >= 0; });
    nearest.push_back(facing != candidates.end() ? *facing : candidates[0]);
  }
  return nearest;
}

}  // namespace

Shape coarse_shape(const Shape& shape, Eigen::Index faces) {
  if (!is_cloud(shape)) return shape.triangles.rows() > faces ? coarse_mesh(shape, faces) : shape;
  if (shape.vertices.rows() <= faces) return shape;
  RandomNumbers random(1);
  const auto n = static_cast<std::size_t>(shape.vertices.rows());
  const std::vector<bool> chosen = random_subset(n, static_cast<std::size_t>(faces), random);
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < n; ++i) {
    if (chosen[i]) rows.push_back(static_cast<Eigen::Index>(i));
  }
  Shape cloud{.vertices = shape.vertices(rows, Eigen::all), .triangles = {}};
  if (shape.normals.rows() > 0) cloud.normals = shape.normals(rows, Eigen::all);
  return cloud;
}

ValueTransfer::ValueTransfer(const Samples& from, const Samples& to)
    : weights_(from.weights), target_of_(nearest_samples(from, to)), nearest_to_(nearest_samples(to, from)) {}

Eigen::VectorXd ValueTransfer::means(const Eigen::VectorXd& values) const {
  const auto count = std::ssize(nearest_to_);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  for (std::size_t i = 0; i < target_of_.size(); ++i) {
    const auto from = static_cast<Eigen::Index>(i);
    if (!std::isfinite(values[from])) continue;
    sums[target_of_[i]] += weights_[from] * values[from];
    weights[target_of_[i]] += weights_[from];
  }
  for (Eigen::Index to = 0; to < count; ++to) {
    sums[to] = weights[to] > 0 ? sums[to] / weights[to] : values[nearest_to_[static_cast<std::size_t>(to)]];
  }
  return sums;
}

Points ValueTransfer::directions(const Points& directions) const {
  Points sums = Points::Zero(std::ssize(nearest_to_), 3);
  for (std::size_t i = 0; i < target_of_.size(); ++i) {
    const auto from = static_cast<Eigen::Index>(i);
    sums.row(target_of_[i]) += weights_[from] * directions.row(from);
  }
  for (Eigen::Index to = 0; to < sums.rows(); ++to) {
    if (sums.row(to).isZero(0)) sums.row(to) = directions.row(nearest_to_[static_cast<std::size_t>(to)]);
    const double length = sums.row(to).norm();
    if (length > 0) sums.row(to) /= length;
  }
  return sums;
}

std::vector<std::int32_t> ValueTransfer::labels(const std::vector<std::int32_t>& labels) const {
  std::vector<std::map<std::int32_t, double>> areas(nearest_to_.size());
  for (std::size_t i = 0; i < target_of_.size(); ++i) {
    areas[static_cast<std::size_t>(target_of_[i])][labels[i]] += weights_[static_cast<Eigen::Index>(i)];
  }
  std::vector<std::int32_t> result;
  for (std::size_t to = 0; to < areas.size(); ++to) {
    const auto largest = std::ranges::max_element(areas[to], {}, &std::pair<const std::int32_t, double>::second);
    result.push_back(largest != areas[to].end() ? largest->first : labels[static_cast<std::size_t>(nearest_to_[to])]);
  }
  return result;
}

ShapeView coarse_view(ShapeView view, const Samples& samples, Eigen::Index faces) {
  Shape coarse = coarse_shape(view.shape, faces);
  if (coarse.vertices.rows() == view.shape.vertices.rows() && coarse.triangles.rows() == view.shape.triangles.rows()) {
    return view;
  }
  const ValueTransfer carried(samples, sample_shape(coarse, view.site));
  for (ViewField& field : view.fields) field.values = carried.means(field.values);
  if (view.normals.rows() > 0) view.normals = carried.directions(view.normals);
  for (ViewParts& parts : view.parts) parts.labels = carried.labels(parts.labels);
  view.shape = std::move(coarse);
  return view;
}

}  // namespace shapegauge
