// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Options of panorama().
struct PanoramaOptions {
  int angles = 128;       ///< number of cells around a cylinder, a multiple of 64
  int heights = 64;       ///< number of cells along a cylinder's axis, a multiple of 64
  int frequencies = 12;   ///< highest Fourier frequency, around and along a cylinder
  double exponent = 0.7;  ///< exponent of the Fourier magnitudes
  double sharpness = 4;   ///< exponent of the cosines between normals and lines of sight
  double radius = 3;      ///< radius of the cylinders, in root mean square distances of the surface from its centroid
};

/// Computes the panoramic views of a shape (Papadakis, Pratikakis, Theoharis, Perantonis 2010).
///
/// The surface's centroid is the origin. Two poses with three axes each are used: the principal axes of the surface,
/// and those of its normals, by decreasing variance. A flat shape is tilted by 45 degrees about its longest axis
/// instead, because cylinders around its principal axes see its edges only. For each axis, project_on_cylinder()
/// computes two maps: distances, and cosines of the normals to the power of `sharpness`. The features of a map are the
/// magnitudes of its Fourier coefficients up to `frequencies` around and along the axis, divided by their sum, to the
/// power of `exponent`, and the mean, standard deviation and skewness of the absolute Haar wavelet coefficients in each
/// subband of six levels.
///
/// Fourier magnitudes are invariant to shifts of a map and to its reversal in both directions. Mirroring a map in one
/// direction exchanges the coefficients of opposite frequencies along the axis; the features are their maximum and
/// minimum. Mirroring only changes signs and positions of Haar coefficients. The descriptor is therefore independent of
/// the signs of axes and of reflections. Axes of equal variance have no unique order; the distance then relies on the
/// other pose.
///
/// Invariant to scale, position and orientation of triangles; duplicate triangles are ignored. Clouds are described by
/// surface_mesh(). Returns the features by pose: 3 x 2 x 2 x (frequencies + 1)^2 Fourier features, by axis, map,
/// maximum and minimum, frequency around and frequency along the axis, then 3 x 2 x 19 x 3 wavelet features, by axis,
/// map, subband and statistic; 4,740 by default. Throws InputError for options out of range, an unusable shape, and one
/// without area.
Eigen::VectorXf panorama(const Shape& shape, const PanoramaOptions& options = {});

/// Computes the distance between two feature vectors of panorama(), the smaller of the distances in the two poses: the
/// L1 distance of the Fourier features plus 20 times the mean of |x - y| / (|x| + |y|) over the wavelet features
/// (Canberra distance). The second summand is about half of the first for unrelated shapes.
double panorama_distance(std::span<const float> a, std::span<const float> b);

/// Returns the entry "panorama" of the registry descriptors().
Descriptor panorama_descriptor();

}  // namespace shapegauge
