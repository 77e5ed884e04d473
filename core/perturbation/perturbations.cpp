#include "shapegauge/core/perturbation/perturbations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/sample_surface.h"

namespace shapegauge {

namespace {

/// Two independent normal numbers.
Eigen::Vector2d gaussian_pair(RandomNumbers& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform(0, 1)));  // never the logarithm of 0
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Eigen::Vector3d gaussian_vector(RandomNumbers& random) {
  const Eigen::Vector2d first = gaussian_pair(random);
  const Eigen::Vector2d second = gaussian_pair(random);
  return {first[0], first[1], second[0]};
}

Eigen::Vector3d point_in_unit_ball(RandomNumbers& random) {
  for (;;) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = random.uniform(-1, 1);
    if (x * x + y * y + z * z <= 1) return {x, y, z};
  }
}

Eigen::Matrix3d uniform_rotation(RandomNumbers& random) {
  const double u = random.uniform(0, 1);
  const double first = random.uniform(0, 2 * std::numbers::pi);
  const double second = random.uniform(0, 2 * std::numbers::pi);
  return Eigen::Quaterniond(std::sqrt(u) * std::cos(second), std::sqrt(1 - u) * std::sin(first),
                            std::sqrt(1 - u) * std::cos(first), std::sqrt(u) * std::sin(second))
      .normalized()
      .toRotationMatrix();
}

double required_diagonal(const Shape& shape) {
  const double diagonal = bounding_box_diagonal(shape);
  if (!std::isnormal(diagonal)) {
    throw InputError(fmt::format(
        "the shape cannot be changed in proportion to its size: the diagonal of its bounding box is {}", diagonal));
  }
  return diagonal;
}

namespace {

/// Moves the rows that are not marked to the front and drops the others.
template <typename Rows>
void remove_rows(Rows& rows, const std::vector<bool>& removed) {
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    if (removed[static_cast<std::size_t>(i)]) continue;
    if (kept != i) rows.row(kept) = rows.row(i);
    ++kept;
  }
  rows.conservativeResize(kept, Eigen::NoChange);
}

}  // namespace

Eigen::Index element_count(const Shape& shape) {
  return is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows();
}

std::vector<bool> random_selection(Eigen::Index count, double fraction, RandomNumbers& random) {
  if (!(fraction >= 0 && fraction <= 1)) {
    throw InputError(fmt::format("a fraction of the shape's parts must be from 0 to 1, not {}", fraction));
  }
  std::vector<bool> selected(static_cast<std::size_t>(count));
  auto wanted = static_cast<double>(std::llround(fraction * static_cast<double>(count)));
  auto remaining = static_cast<double>(count);
  for (auto&& mark : selected) {
    mark = random.uniform(0, remaining) < wanted;
    if (mark) --wanted;
    --remaining;
  }
  return selected;
}

Shape without_elements(Shape shape, const std::vector<bool>& removed) {
  if (std::ranges::find(removed, false) == removed.end()) {
    throw InputError(fmt::format("nothing would be left of the shape's {} {}", removed.size(),
                                 is_cloud(shape) ? "points" : "faces"));
  }
  if (is_cloud(shape)) {
    remove_rows(shape.vertices, removed);
    if (shape.normals.rows() > 0) remove_rows(shape.normals, removed);
  } else {
    remove_rows(shape.triangles, removed);
  }
  return shape;
}

Shape vertex_noise(Shape shape, const VertexNoiseOptions& options, RandomNumbers& random) {
  if (!(options.amplitude >= 0 && std::isfinite(options.amplitude))) {
    throw InputError(fmt::format("the amplitude of noise must be a number of at least 0, not {}", options.amplitude));
  }
  const double length = options.amplitude * required_diagonal(shape);
  const bool gaussian = options.distribution == NoiseDistribution::gaussian;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    const Eigen::Vector3d displacement = gaussian ? gaussian_vector(random) : point_in_unit_ball(random);
    shape.vertices.row(i) += length * displacement.transpose();
  }
  return shape;
}

Shape remove_faces(Shape shape, double fraction, RandomNumbers& random) {
  const std::vector<bool> removed = random_selection(element_count(shape), fraction, random);
  return without_elements(std::move(shape), removed);
}

Shape flip_orientation(Shape shape, double fraction, RandomNumbers& random) {
  const std::vector<bool> flipped = random_selection(element_count(shape), fraction, random);
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    if (!flipped[i]) continue;
    const auto element = static_cast<Eigen::Index>(i);
    if (!is_cloud(shape)) {
      std::swap(shape.triangles(element, 1), shape.triangles(element, 2));
    } else if (shape.normals.rows() > 0) {
      shape.normals.row(element) *= -1;
    }
  }
  return shape;
}

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

Shape random_motion(Shape shape, double scale, RandomNumbers& random) {
  if (!(scale >= 1 && std::isfinite(scale))) {
    throw InputError(fmt::format("the largest scale of a motion must be a number of at least 1, not {}", scale));
  }
  const Eigen::RowVector3d shift = required_diagonal(shape) * point_in_unit_ball(random).transpose();
  const Eigen::Matrix3d rotation = uniform_rotation(random);
  const double factor = std::exp(std::log(scale) * random.uniform(-1, 1));
  const Eigen::RowVector3d centre = bounding_box(shape).center().transpose();
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    const Eigen::RowVector3d turned = factor * (shape.vertices.row(i) - centre) * rotation.transpose();
    shape.vertices.row(i) = turned + centre + shift;
  }
  for (Eigen::Index i = 0; i < shape.normals.rows(); ++i) {
    const Eigen::RowVector3d turned = shape.normals.row(i) * rotation.transpose();
    shape.normals.row(i) = turned;
  }
  return shape;
}

}  // namespace shapegauge
