// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/base/registry.h"
#include "shapegauge/core/shape/shape.h"

/// Reproducible random perturbations: the same random stream gives the same shape. See also decimate.h and
/// sample_points.h.
namespace shapegauge {

/// Distribution of the random displacements of vertex_noise().
enum class NoiseDistribution {
  gaussian,  ///< standard deviation of each coordinate = amplitude
  uniform    ///< uniform in a ball of radius = amplitude
};
template <>
inline constexpr std::array<std::string_view, 2> words_of<NoiseDistribution>{"gaussian", "uniform"};

/// Options of vertex_noise().
struct VertexNoiseOptions {
  double amplitude = 0.005;  ///< size of the displacements (NoiseDistribution), in bounding-box diagonals
  NoiseDistribution distribution = NoiseDistribution::uniform;  ///< distribution of the displacements
};

/// Names, bounds and help texts of the parameters in VertexNoiseOptions (option_parameters.h).
inline constexpr std::array vertex_noise_table = {
    without_default(
        with_unit(bounding_box_diagonals,
                  option_of<&VertexNoiseOptions::amplitude>(
                      "amplitude", {.low = 0, .high = 1},
                      "Maximum displacement; with distribution gaussian: standard deviation per coordinate."))),
    option_of<&VertexNoiseOptions::distribution>(
        "distribution", "Distribution of displacements. gaussian: in each coordinate; uniform: in a ball."),
};

/// Moves every vertex of a mesh, or point of a cloud, by an independent random vector. Coincident vertices move apart,
/// which tears a triangle soup. The normals of a cloud stay. Throws InputError for an amplitude out of bounds and for a
/// shape without extent.
Shape vertex_noise(Shape shape, const VertexNoiseOptions& options, RandomNumbers& random);

/// Valid range of the fraction of a shape's elements (triangles, or points of a cloud) to perturb.
inline constexpr Bounds fraction_bounds{.low = 0, .high = 1};

/// Removes exactly round(fraction * n) of a mesh's n faces, or of a cloud's n points, at random. All vertices of a mesh
/// stay, which preserves their indices. Throws InputError for a fraction out of bounds, and if nothing would be left.
Shape remove_faces(Shape shape, double fraction, RandomNumbers& random);

/// Reverses exactly round(fraction * n) of a mesh's n faces, or of a cloud's n normals, at random. Leaves a cloud
/// without normals unchanged. Throws InputError for a fraction out of bounds.
Shape flip_orientation(Shape shape, double fraction, RandomNumbers& random);

/// Options of punch_holes().
struct PunchHolesOptions {
  int number = 5;        ///< number of holes; they may overlap
  double radius = 0.05;  ///< radius of a hole, as a fraction of the bounding-box diagonal
};

/// Names, bounds and help texts of the parameters in PunchHolesOptions (option_parameters.h).
inline constexpr std::array punch_holes_table = {
    option_of<&PunchHolesOptions::number>("number", {.low = 0, .high = 100'000}, "Number of holes."),
    with_unit(bounding_box_diagonals,
              option_of<&PunchHolesOptions::radius>("radius", {.low = 0, .high = 1}, "Radius of each hole.")),
};

/// Removes the faces whose centroids lie within `radius` of one of `number` random points of the surface
/// (sample_points()); of a cloud, the points within that radius. Holes go through thin parts. All vertices of a mesh
/// stay. Throws InputError for options out of bounds, for a shape without extent or area, and if nothing would be left.
Shape punch_holes(Shape shape, const PunchHolesOptions& options, RandomNumbers& random);

/// Valid range of the maximum scale factor of random_motion().
inline constexpr Bounds motion_scale_bounds{.low = 1, .high = 1e6};

/// Applies a random similarity transform. The rotation about the centre of the bounding box is uniform over all
/// rotations. The scale factor is log-uniform in [1 / `scale`, `scale`]. The translation is uniform in a ball whose
/// radius is the bounding-box diagonal. The normals of a cloud rotate with it. Throws InputError for a scale out of
/// bounds and for a shape without extent.
Shape random_motion(Shape shape, double scale, RandomNumbers& random);

/// Entry of shape_perturbations(): a kind of perturbation, its name in configurations, and its parameters.
struct ShapePerturbation {
  std::string_view name;                  ///< name in configurations
  std::string_view description;           ///< effect of the perturbation in one sentence, for help texts
  std::span<const Parameter> parameters;  ///< parameters that configurations may set
  /// Applies the perturbation. `settings` are complete values of `parameters`. Throws InputError for an unsuitable
  /// shape.
  Shape (*apply)(Shape shape, const ParameterValues& settings, RandomNumbers& random) = nullptr;
  int version = 1;  ///< cache version; increment when results change (docs/manual/cache.md)
  /// Returns a sentence on how the result falls short of the settings, such as too many faces; empty if it does not.
  /// Null if results never fall short.
  std::string (*remark)(const Shape& result, const ParameterValues& settings) = nullptr;
};

/// Returns the registry of shape perturbations: the built-in ones, followed by added ones. An entry must have
/// `apply`.
Registry<ShapePerturbation>& shape_perturbations();

// Building blocks.

/// Returns three independent standard normal coordinates (Box and Muller 1958).
Eigen::Vector3d gaussian_vector(RandomNumbers& random);

/// Returns a point uniform in the unit ball.
Eigen::Vector3d point_in_unit_ball(RandomNumbers& random);

/// Returns a rotation uniform over all rotations (Shoemake 1992).
Eigen::Matrix3d uniform_rotation(RandomNumbers& random);

/// Returns the bounding-box diagonal, as the unit of relative lengths. Throws InputError if it is zero, subnormal or
/// not finite.
double required_diagonal(const Shape& shape);

/// Returns the number of elements of a shape: triangles of a mesh, points of a cloud.
Eigen::Index element_count(const Shape& shape);

/// Marks exactly round(fraction * count) of `count` elements as true, at random (random_subset()). Throws InputError
/// for a fraction out of bounds.
std::vector<bool> random_selection(Eigen::Index count, double fraction, RandomNumbers& random);

/// Removes the marked elements of a shape (triangles, or points of a cloud); the others keep their order. All vertices
/// of a mesh stay. Throws InputError if nothing would be left.
Shape without_elements(Shape shape, const std::vector<bool>& removed);

}  // namespace shapegauge
