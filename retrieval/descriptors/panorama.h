#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Cache version; increment when features or distances change.
inline constexpr int panorama_version = 1;

/// Options of panorama().
struct PanoramaOptions {
  int angles = 128;       ///< cells around a cylinder
  int heights = 64;       ///< cells along it
  int frequencies = 8;    ///< highest Fourier frequency in either direction
  double exponent = 0.7;  ///< of the Fourier magnitudes
  double sharpness = 4;   ///< exponent of the cosines between normals and lines of sight
  double radius = 3;      ///< of the cylinders, in root mean squares of the surface's distance from its centroid
};

/// Computes the panoramic views of a shape (Papadakis, Pratikakis, Theoharis, Perantonis 2010).
///
/// The surface's centroid is the origin. Two poses give three axes each: the principal axes of the surface, and of its
/// normals, by falling variance. About each axis a cylinder receives two maps (project_on_cylinder()): distances, and
/// cosines of the normals to the power of `sharpness`. The features of a map are the magnitudes of its Fourier
/// coefficients up to `frequencies` around and along the axis, divided by their sum, to the power of `exponent`.
///
/// Fourier magnitudes do not change as a map is shifted, or read backwards in both directions. A map mirrored in one
/// direction exchanges coefficients of opposite frequency along the axis; features are the greater and then the lesser
/// of both. So neither the signs of axes nor a reflection of the shape matter. Axes of equal variance have no order;
/// the other pose then has to help.
///
/// Scale, place, orientation of triangles and doubled triangles do not matter. Clouds are described by splatted().
/// Returns 2 x 3 x 2 x 2 x (frequencies + 1)^2 features, 1,944 by default: by pose, axis, map, greater and lesser,
/// frequency around and frequency along the axis. Throws InputError for options out of range, an unusable shape, and
/// one without area.
Eigen::VectorXf panorama(const Shape& shape, const PanoramaOptions& options = {});

/// Returns the lesser of the L1 distances between two shapes in the one pose and in the other.
double panorama_distance(std::span<const float> a, std::span<const float> b);

Descriptor panorama_descriptor();

}  // namespace shapegauge
