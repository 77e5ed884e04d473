// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/sound_mesh.h"

#include <cstddef>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

namespace {

/// Returns the index of each triangle among those with three distinct corners, or -1.
std::vector<std::int32_t> numbers_of_sound(const Shape& mesh) {
  const std::vector<std::int32_t> merged = welded_vertices(mesh.vertices);
  std::vector<std::int32_t> numbers;
  std::int32_t next = 0;
  for (const auto& corners : mesh.triangles.rowwise()) {
    const auto corner = [&](int k) { return merged[static_cast<std::size_t>(corners[k])]; };
    const bool sound = corner(0) != corner(1) && corner(1) != corner(2) && corner(2) != corner(0);
    numbers.push_back(sound ? next++ : -1);
  }
  if (next == 0)
    throw InputError(
        "a shape without area cannot be segmented; check it for degenerate triangles or coincident points");
  return numbers;
}

/// Returns the closest of the sound triangles to the middle of a triangle.
std::int32_t closest_to(const Shape& mesh, Eigen::Index triangle, const TriangleBVH& sound, const UnitFrame& frame) {
  constexpr double far = 100;  // in single precision, all triangles are about equally near to farther points
  const Eigen::Vector3d middle = mesh.vertices(mesh.triangles.row(triangle), Eigen::all).colwise().mean();
  return sound.closest(frame.to_unit(middle).cwiseMax(-far).cwiseMin(far)).value().triangle;
}

}  // namespace

std::vector<std::int32_t> SoundMesh::extended(std::vector<std::int32_t> labels) const {
  if (labels.size() == triangle_of.size() || triangle_of.empty()) return labels;
  std::vector<std::int32_t> all = triangle_of;
  for (std::int32_t& triangle : all) triangle = labels[static_cast<std::size_t>(triangle)];
  return all;
}

SoundMesh sound_mesh(const Shape& original) {
  require_usable(original);
  DistinctTriangles distinct = distinct_triangles(original);
  SoundMesh result{.shape = std::move(distinct.shape), .triangle_of = std::move(distinct.triangle_of)};
  if (is_cloud(original)) return result;
  const Shape mesh = result.shape;
  std::vector<std::int32_t> number = numbers_of_sound(mesh);
  std::vector<Eigen::Index> selected;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] >= 0) selected.push_back(static_cast<Eigen::Index>(i));
  }
  if (selected.size() == number.size()) return result;
  result.shape.triangles = mesh.triangles(selected, Eigen::all).eval();
  result.shape.polygons = {};
  const UnitFrame frame = unit_frame(result.shape);
  const TriangleBVH sound(in_unit_frame(result.shape, frame));
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) number[i] = closest_to(mesh, static_cast<Eigen::Index>(i), sound, frame);
  }
  for (std::int32_t& triangle : result.triangle_of) triangle = number[static_cast<std::size_t>(triangle)];
  return result;
}

}  // namespace shapegauge
