#include "shapegauge/core/perturbation/punch_holes.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/required_extent.h"
#include "shapegauge/core/perturbation/sample_surface.h"
#include "shapegauge/core/perturbation/shape_elements.h"

namespace shapegauge {

namespace {

/// Where an element is: a triangle's centroid, or the point.
Eigen::RowVector3d place_of(const Shape& shape, Eigen::Index element) {
  if (is_cloud(shape)) return shape.vertices.row(element);
  const auto corners = shape.triangles.row(element);
  return shape.vertices.row(corners[0]) / 3 + shape.vertices.row(corners[1]) / 3 + shape.vertices.row(corners[2]) / 3;
}

}  // namespace

Shape punch_holes(Shape shape, const PunchHolesOptions& options, RandomNumbers& random) {
  if (options.number < 0 || !(options.radius >= 0 && std::isfinite(options.radius))) {
    throw InputError(fmt::format("the number and the radius of holes must be at least 0, not {} and {}", options.number,
                                 options.radius));
  }
  if (options.number == 0) return shape;
  const double radius = options.radius * required_diagonal(shape);
  const Points centres = sample_surface(shape, {.points = options.number}, random).vertices;
  std::vector<bool> removed(static_cast<std::size_t>(element_count(shape)));
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const Eigen::RowVector3d place = place_of(shape, static_cast<Eigen::Index>(i));
    removed[i] = ((centres.rowwise() - place).rowwise().norm().array() <= radius).any();
  }
  return without_elements(std::move(shape), removed);
}

}  // namespace shapegauge
