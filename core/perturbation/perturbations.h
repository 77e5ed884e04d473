#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Independent normal coordinates of mean 0 and standard deviation 1 (Box and Muller 1958).
Eigen::Vector3d gaussian_vector(RandomNumbers& random);

/// Uniform in the ball of radius 1 about the origin.
Eigen::Vector3d point_in_unit_ball(RandomNumbers& random);

/// Uniform over all rotations (Shoemake 1992).
Eigen::Matrix3d uniform_rotation(RandomNumbers& random);

/// The diagonal of the bounding box. Throws InputError where it is zero or not a normal number: there is no length then
/// to take a fraction of.
double required_diagonal(const Shape& shape);

/// The number of a shape's elements: of the triangles of a mesh, of the points of a cloud.
Eigen::Index element_count(const Shape& shape);

/// Exactly round(fraction * count) of the elements, every set of that size as likely as any other (selection sampling:
/// Knuth, The Art of Computer Programming, 3.4.2, algorithm S). Throws InputError unless the fraction is in [0, 1].
std::vector<bool> random_selection(Eigen::Index count, double fraction, RandomNumbers& random);

/// The shape without the elements that are marked; the others keep their order. The vertices of a mesh all stay. Throws
/// InputError where nothing would be left.
Shape without_elements(Shape shape, const std::vector<bool>& removed);

/// How a random displacement is distributed.
enum class NoiseDistribution {
  gaussian,  ///< each coordinate has the amplitude as its standard deviation
  uniform    ///< uniform in the ball whose radius is the amplitude
};

struct VertexNoiseOptions {
  double amplitude = 0.005;  ///< as a fraction of the bounding box's diagonal; at least 0
  NoiseDistribution distribution = NoiseDistribution::uniform;
};

/// The shape with every vertex (or point of a cloud) moved by a random vector of its own. Vertices are told apart by
/// index: those at the same place that are not one vertex part, and a soup comes apart. A cloud's normals stay. Throws
/// InputError for an amplitude that is negative or not finite, and for a shape without extent.
Shape vertex_noise(Shape shape, const VertexNoiseOptions& options, RandomNumbers& random);

/// The mesh without exactly round(fraction * n) of its n faces, chosen at random; a cloud without as many of its
/// points. The vertices of a mesh all stay, so that indices keep their meaning. Throws InputError unless the fraction
/// is in [0, 1] and something is left.
Shape remove_faces(Shape shape, double fraction, RandomNumbers& random);

/// The mesh with exactly round(fraction * n) of its n faces, chosen at random, turned over (1: all of them); a cloud
/// with as many of its normals reversed, where it has any. Throws InputError unless the fraction is in [0, 1].
Shape flip_orientation(Shape shape, double fraction, RandomNumbers& random);

struct PunchHolesOptions {
  int number = 5;        ///< of holes; they may overlap
  double radius = 0.05;  ///< as a fraction of the bounding box's diagonal; at least 0
};

/// The mesh without the faces whose centroid is within the radius of one of so many points, random on its surface (see
/// sample_surface); a cloud without its points within the radius of some of them. Holes reach through thin parts. The
/// vertices of a mesh all stay. Throws InputError for options out of range, for a shape without extent or area, and
/// where nothing would be left.
Shape punch_holes(Shape shape, const PunchHolesOptions& options, RandomNumbers& random);

/// The shape moved at random: turned about the centre of its bounding box by a rotation uniform over all rotations,
/// scaled about it by a factor between 1 / scale and scale whose logarithm is uniform (1: not scaled), and shifted by a
/// vector uniform in the ball whose radius is the diagonal of its bounding box. A cloud's normals turn with it. Throws
/// InputError for a scale that is below 1 or not finite, and for a shape without extent.
Shape random_motion(Shape shape, double scale, RandomNumbers& random);

}  // namespace shapegauge
