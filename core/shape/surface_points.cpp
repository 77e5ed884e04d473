#include "shapegauge/core/shape/surface_points.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/error.h"

namespace shapegauge {

namespace {

/// The sum of the areas up to and with each triangle.
Eigen::VectorXd running_areas(const Shape& mesh) {
  Eigen::VectorXd areas = triangle_areas(mesh);
  for (Eigen::Index f = 1; f < areas.size(); ++f) areas[f] += areas[f - 1];
  const double total = areas.size() > 0 ? areas[areas.size() - 1] : 0;
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

}  // namespace

SurfacePoints surface_points(const Shape& mesh, Eigen::Index count, RandomNumbers& random) {
  if (count < 1) throw InputError(fmt::format("the number of points must be at least 1, not {}", count));
  const Eigen::VectorXd areas = running_areas(mesh);
  const double total = areas.size() > 0 ? areas[areas.size() - 1] : 0;
  const double part = total / static_cast<double>(count);
  SurfacePoints result{Points(count, 3), std::vector<std::int32_t>(static_cast<std::size_t>(count))};
  for (Eigen::Index i = 0; i < count; ++i) {
    const double area = part * random.uniform(static_cast<double>(i), static_cast<double>(i + 1));
    // The first sum beyond it is of a triangle that has an area; rounding must not lead past the last one that has.
    const double below_total = std::min(area, std::nextafter(total, 0.0));
    const auto triangle = std::upper_bound(areas.begin(), areas.end(), below_total) - areas.begin();
    result.points.row(i) = point_on(mesh, triangle, random);
    result.triangles[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(triangle);
  }
  return result;
}

}  // namespace shapegauge
