#include "shapegauge/core/perturbation/sample_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/shape_elements.h"

namespace shapegauge {

namespace {

/// So many of a cloud's points.
Shape thinned(const Shape& cloud, const SampleSurfaceOptions& options, RandomNumbers& random) {
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

/// The sum of the areas up to and with each triangle.
Eigen::VectorXd running_areas(const Shape& mesh) {
  Eigen::VectorXd areas = triangle_areas(mesh);
  for (Eigen::Index f = 1; f < areas.size(); ++f) areas[f] += areas[f - 1];
  const double total = areas[areas.size() - 1];
  if (!std::isnormal(total)) {
    throw InputError(
        fmt::format("no points can be taken of the surface: the area of its {} triangles is {}; it needs "
                    "a triangle of positive, finite area",
                    areas.size(), total));
  }
  return areas;
}

/// Uniform on a triangle (Turk 1990).
Eigen::RowVector3d point_on(const Shape& mesh, Eigen::Index triangle, RandomNumbers& random) {
  const double root = std::sqrt(random.uniform(0, 1));
  const double along = random.uniform(0, 1);
  const auto corners = mesh.triangles.row(triangle);
  return (1 - root) * mesh.vertices.row(corners[0]) + root * (1 - along) * mesh.vertices.row(corners[1]) +
         root * along * mesh.vertices.row(corners[2]);
}

Eigen::RowVector3d normal_of(const Shape& mesh, Eigen::Index triangle) {
  const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(triangle, 0));
  const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(triangle, 1));
  const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(triangle, 2));
  return (b - a).cross(c - a).stableNormalized().transpose();
}

}  // namespace

Shape sample_surface(const Shape& shape, const SampleSurfaceOptions& options, RandomNumbers& random) {
  if (options.points < 1) {
    throw InputError(fmt::format("the number of points must be at least 1, not {}", options.points));
  }
  if (shape.vertices.rows() == 0) throw InputError("no points can be taken of a shape without any");
  if (is_cloud(shape)) return thinned(shape, options, random);
  const Eigen::VectorXd areas = running_areas(shape);
  const double part = areas[areas.size() - 1] / static_cast<double>(options.points);
  Shape cloud;
  cloud.vertices.resize(options.points, 3);
  if (options.with_normals) cloud.normals.resize(options.points, 3);
  for (Eigen::Index i = 0; i < options.points; ++i) {
    const double area = part * random.uniform(static_cast<double>(i), static_cast<double>(i + 1));
    // The first sum beyond it is of a triangle that has an area; rounding must not lead past the last one that has.
    const double below_total = std::min(area, std::nextafter(areas[areas.size() - 1], 0.0));
    const auto triangle = std::upper_bound(areas.begin(), areas.end(), below_total) - areas.begin();
    cloud.vertices.row(i) = point_on(shape, triangle, random);
    if (options.with_normals) cloud.normals.row(i) = normal_of(shape, triangle);
  }
  return cloud;
}

}  // namespace shapegauge
