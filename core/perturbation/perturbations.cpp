// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/perturbation/perturbations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/perturbation/sample_points.h"

namespace shapegauge {

namespace {

/// Returns two independent standard normal numbers.
Eigen::Vector2d gaussian_pair(RandomNumbers& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform(0, 1)));  // never the logarithm of 0
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Moves the unmarked rows to the front and drops the others.
template <typename Rows>
void remove_rows(Rows& rows, const std::vector<bool>& removed) {
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    if (removed[static_cast<std::size_t>(i)]) continue;
    if (count != i) rows.row(count) = rows.row(i);
    ++count;
  }
  rows.conservativeResize(count, Eigen::NoChange);
}

/// Returns a triangle's centroid, or the point of a cloud.
Eigen::RowVector3d centre_of_element(const Shape& shape, Eigen::Index element) {
  if (is_cloud(shape)) return shape.vertices.row(element);
  const auto corners = shape.triangles.row(element);
  return shape.vertices.row(corners[0]) / 3 + shape.vertices.row(corners[1]) / 3 + shape.vertices.row(corners[2]) / 3;
}

constexpr auto vertex_noise_parameters = parameters_of(vertex_noise_table);

constexpr std::array remove_faces_parameters{
    Parameter{.name = "fraction", .bounds = fraction_bounds, .description = "Fraction of faces or points to remove."}};

constexpr auto punch_holes_parameters = parameters_of(punch_holes_table);

constexpr std::array decimate_parameters{
    Parameter{.name = "faces",
              .kind = ParameterKind::integer,
              .bounds = decimate_faces_bounds,
              .description = "Target number of faces; meshes with fewer are unchanged."}};

constexpr auto sample_points_parameters = parameters_of(sample_points_table);

constexpr std::array flip_orientation_parameters{Parameter{.name = "fraction",
                                                           .default_value = 1.0,
                                                           .bounds = fraction_bounds,
                                                           .description = "Fraction of faces or normals to reverse."}};

constexpr std::array motion_parameters{
    Parameter{.name = "scale",
              .default_value = 1.0,
              .bounds = motion_scale_bounds,
              .description = "Maximum scale factor (minimum: its reciprocal); 1: no scaling."}};

// NOLINTBEGIN(performance-unnecessary-value-param): all have the type of Perturbation::apply.
Shape apply_vertex_noise(Shape shape, const ParameterValues& settings, RandomNumbers& random) {
  return vertex_noise(std::move(shape), options_from(vertex_noise_table, settings), random);
}

Shape apply_remove_faces(Shape shape, const ParameterValues& settings, RandomNumbers& random) {
  return remove_faces(std::move(shape), settings.number("fraction"), random);
}

Shape apply_punch_holes(Shape shape, const ParameterValues& settings, RandomNumbers& random) {
  return punch_holes(std::move(shape), options_from(punch_holes_table, settings), random);
}

Shape apply_decimate(Shape shape, const ParameterValues& settings, RandomNumbers& /*random*/) {
  return decimate(shape, settings.integer("faces"));
}

std::string remark_on_decimation(const Shape& result, const ParameterValues& settings) {
  const std::int64_t requested = settings.integer("faces");
  if (result.triangles.rows() <= requested) return {};
  return fmt::format("decimated to {} faces instead of {}: no valid collapse is left", result.triangles.rows(),
                     requested);
}

Shape apply_sample_points(Shape shape, const ParameterValues& settings, RandomNumbers& random) {
  return sample_points(shape, options_from(sample_points_table, settings), random);
}

Shape apply_vertex_cloud(Shape shape, const ParameterValues& /*settings*/, RandomNumbers& /*random*/) {
  return vertex_cloud(shape);
}

Shape apply_flip_orientation(Shape shape, const ParameterValues& settings, RandomNumbers& random) {
  return flip_orientation(std::move(shape), settings.number("fraction"), random);
}

Shape apply_random_motion(Shape shape, const ParameterValues& settings, RandomNumbers& random) {
  return random_motion(std::move(shape), settings.number("scale"), random);
}
// NOLINTEND(performance-unnecessary-value-param)

std::vector<ShapePerturbation> builtin_perturbations() {
  return {
      {"vertex_noise", "Move vertices or points at random.", vertex_noise_parameters, apply_vertex_noise},
      {"remove_faces", "Remove random faces (clouds: points).", remove_faces_parameters, apply_remove_faces},
      {"holes", "Cut round holes at random positions.", punch_holes_parameters, apply_punch_holes},
      {"decimate", "Simplify the mesh by quadric error metrics.", decimate_parameters, apply_decimate, 1,
       remark_on_decimation},
      {"sample_points", "Replace the mesh by random points, uniform by area.", sample_points_parameters,
       apply_sample_points},
      {"vertex_cloud", "Replace the mesh by the cloud of its vertices.", {}, apply_vertex_cloud},
      {"flip_orientation", "Reverse the orientation of random faces (clouds: normals).", flip_orientation_parameters,
       apply_flip_orientation},
      {"motion", "Rotate, translate and scale at random.", motion_parameters, apply_random_motion},
  };
}

}  // namespace

Shape vertex_noise(Shape shape, const VertexNoiseOptions& options, RandomNumbers& random) {
  check_options("vertex_noise", vertex_noise_table, options);
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

Shape punch_holes(Shape shape, const PunchHolesOptions& options, RandomNumbers& random) {
  check_options("holes", punch_holes_table, options);
  if (options.number == 0) return shape;
  const double radius = options.radius * required_diagonal(shape);
  const Points centres = sample_points(shape, {.points = options.number}, random).vertices;
  std::vector<bool> removed(static_cast<std::size_t>(element_count(shape)));
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const Eigen::RowVector3d centre = centre_of_element(shape, static_cast<Eigen::Index>(i));
    removed[i] = ((centres.rowwise() - centre).rowwise().norm().array() <= radius).any();
  }
  return without_elements(std::move(shape), removed);
}

Shape random_motion(Shape shape, double scale, RandomNumbers& random) {
  require_in_bounds("the largest scale of a motion", scale, motion_scale_bounds);
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

Registry<ShapePerturbation>& shape_perturbations() {
  static Registry<ShapePerturbation> all("perturbation", builtin_perturbations(),
                                         has_functions<&ShapePerturbation::apply>);
  return all;
}

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
        "the perturbation is relative to the size of the shape, but the diagonal of its bounding box is {}", diagonal));
  }
  return diagonal;
}

Eigen::Index element_count(const Shape& shape) {
  return is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows();
}

std::vector<bool> random_selection(Eigen::Index count, double fraction, RandomNumbers& random) {
  require_in_bounds("the fraction of the shape's faces or points", fraction, fraction_bounds);
  const auto selected = static_cast<std::size_t>(std::llround(fraction * static_cast<double>(count)));
  return random_subset(static_cast<std::size_t>(count), selected, random);
}

Shape without_elements(Shape shape, const std::vector<bool>& removed) {
  if (std::ranges::find(removed, false) == removed.end()) {
    throw InputError(fmt::format("nothing would be left of the shape's {} {}; remove fewer", removed.size(),
                                 is_cloud(shape) ? "points" : "faces"));
  }
  if (is_cloud(shape)) {
    remove_rows(shape.vertices, removed);
    if (shape.normals.rows() > 0) remove_rows(shape.normals, removed);
  } else {
    remove_rows(shape.triangles, removed);
    shape.polygons = {};
  }
  return shape;
}

}  // namespace shapegauge
