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

/// Damage and change, at random but repeatable: the same stream of random numbers gives the same shape. See also
/// decimate.h and sample_points.h.
namespace shapegauge {

/// How a random displacement is distributed.
enum class NoiseDistribution {
  gaussian,  ///< the amplitude is the standard deviation of each coordinate
  uniform    ///< the amplitude is the radius of a ball
};
template <>
inline constexpr std::array<std::string_view, 2> words_of<NoiseDistribution>{"gaussian", "uniform"};

struct VertexNoiseOptions {
  double amplitude = 0.005;  ///< as a fraction of the bounding-box diagonal
  NoiseDistribution distribution = NoiseDistribution::uniform;
};

/// What may be chosen of VertexNoiseOptions.
inline constexpr std::array vertex_noise_table = {
    required(option_of<&VertexNoiseOptions::amplitude>(
        "amplitude", {.low = 0, .high = 1}, "Length of the vector, as a fraction of the bounding box's diagonal.")),
    option_of<&VertexNoiseOptions::distribution>("distribution",
                                                 "gaussian: each coordinate has the amplitude as its standard "
                                                 "deviation; uniform: in the ball whose radius is the amplitude."),
};

/// Moves every vertex (or point of a cloud) by a random vector of its own. Vertices are told apart by index: duplicates
/// at one place part, and a soup comes apart. A cloud's normals stay. Throws InputError for an amplitude out of bounds,
/// and for a shape without extent.
Shape vertex_noise(Shape shape, const VertexNoiseOptions& options, RandomNumbers& random);

/// A fraction of a shape's elements.
inline constexpr Bounds fraction_bounds{.low = 0, .high = 1};

/// Removes exactly round(fraction * n) of a mesh's n faces, chosen at random; of a cloud, as many of its points. The
/// vertices of a mesh all stay, so that indices keep their meaning. Throws InputError for a fraction out of bounds, and
/// where nothing would be left.
Shape remove_faces(Shape shape, double fraction, RandomNumbers& random);

/// Reverses exactly round(fraction * n) of a mesh's n faces, chosen at random; of a cloud, as many of its normals,
/// where it has any. Throws InputError for a fraction out of bounds.
Shape flip_orientation(Shape shape, double fraction, RandomNumbers& random);

struct PunchHolesOptions {
  int number = 5;        ///< of holes, which may overlap
  double radius = 0.05;  ///< as a fraction of the bounding-box diagonal
};

/// What may be chosen of PunchHolesOptions.
inline constexpr std::array punch_holes_table = {
    option_of<&PunchHolesOptions::number>("number", {.low = 0, .high = 100'000}, "Number of holes."),
    option_of<&PunchHolesOptions::radius>("radius", {.low = 0, .high = 1},
                                          "Radius of a hole, as a fraction of the bounding box's diagonal."),
};

/// Removes the faces whose centroid is within the radius of one of `number` random points of the surface (see
/// sample_points()); of a cloud, the points within the radius of some of them. Holes reach through thin parts. The
/// vertices of a mesh all stay. Throws InputError for options out of bounds, for a shape without extent or area, and
/// where nothing would be left.
Shape punch_holes(Shape shape, const PunchHolesOptions& options, RandomNumbers& random);

/// The largest scale of random_motion().
inline constexpr Bounds motion_scale_bounds{.low = 1, .high = 1e6};

/// Moves the shape at random: rotates it about the centre of its bounding box, uniformly over all rotations, scales it
/// about the centre by a factor between 1 / scale and scale whose logarithm is uniform (1: not at all), and translates
/// it by a vector uniform in the ball whose radius is the bounding-box diagonal. A cloud's normals rotate with it.
/// Throws InputError for a scale out of bounds, and for a shape without extent.
Shape random_motion(Shape shape, double scale, RandomNumbers& random);

/// A kind of perturbation by its name in configurations, with all its parameters.
struct ShapePerturbation {
  std::string_view name;
  std::string_view description;
  std::span<const Parameter> parameters;
  /// The settings are complete and of these parameters. Throws InputError for a shape that cannot be changed so.
  Shape (*apply)(Shape shape, const ParameterValues& settings, RandomNumbers& random);
  int version = 1;  ///< to be raised with every change of what it makes of a shape, so that caches forget the old ones
};

/// All kinds of perturbations of a shape: those of this folder, then those that were added.
Registry<ShapePerturbation>& shape_perturbations();

// Building blocks.

/// Independent normal coordinates of mean 0 and standard deviation 1 (Box and Muller 1958).
Eigen::Vector3d gaussian_vector(RandomNumbers& random);

/// Uniform in the ball of radius 1 about the origin.
Eigen::Vector3d point_in_unit_ball(RandomNumbers& random);

/// Uniform over all rotations (Shoemake 1992).
Eigen::Matrix3d uniform_rotation(RandomNumbers& random);

/// The bounding-box diagonal, for lengths in proportion to it. Throws InputError where it is zero or not a normal
/// number.
double required_diagonal(const Shape& shape);

/// The elements of a mesh are its triangles, those of a cloud its points.
Eigen::Index element_count(const Shape& shape);

/// Marks exactly round(fraction * count) elements at random (random_subset()). Throws InputError for a fraction out of
/// bounds.
std::vector<bool> random_selection(Eigen::Index count, double fraction, RandomNumbers& random);

/// The shape without the marked elements, one mark an element; the others keep their order. The vertices of a mesh all
/// stay. Throws InputError where nothing would be left.
Shape without_elements(Shape shape, const std::vector<bool>& removed);

}  // namespace shapegauge
