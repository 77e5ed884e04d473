// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/perturbation/sample_points.h"

#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

namespace {

/// Selects points of a cloud at random.
Shape thinned(const Shape& cloud, const SamplePointsOptions& options, RandomNumbers& random) {
  const Eigen::Index count = cloud.vertices.rows();
  Shape points = cloud;
  if (options.points < count) {
    const double fraction = static_cast<double>(options.points) / static_cast<double>(count);
    std::vector<bool> removed = random_selection(count, fraction, random);
    removed.flip();
    points = without_elements(std::move(points), removed);
  }
  if (!options.with_normals) points.normals.resize(0, 3);
  return points;
}

}  // namespace

Shape sample_points(const Shape& shape, const SamplePointsOptions& options, RandomNumbers& random) {
  check_options("sample_points", sample_points_table, options);
  if (shape.vertices.rows() == 0) throw InputError("an empty shape cannot be sampled");
  if (is_cloud(shape)) return thinned(shape, options, random);
  SurfacePoints sampled = stratified_points(shape, options.points, random);
  Shape cloud;
  cloud.vertices = std::move(sampled.points);
  if (!options.with_normals) return cloud;
  cloud.normals.resize(options.points, 3);
  for (Eigen::Index i = 0; i < options.points; ++i) {
    cloud.normals.row(i) = triangle_normal(shape, sampled.triangles[static_cast<std::size_t>(i)]);
  }
  return cloud;
}

Shape vertex_cloud(const Shape& shape) {
  if (is_cloud(shape)) return {.vertices = shape.vertices, .triangles = {}};
  const std::vector<bool> used = used_vertices(shape);
  std::vector<Eigen::Index> indices;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    if (used[static_cast<std::size_t>(i)]) indices.push_back(i);
  }
  return {.vertices = shape.vertices(indices, Eigen::all), .triangles = {}};
}

}  // namespace shapegauge
