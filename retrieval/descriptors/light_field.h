// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Options of light_field().
struct LightFieldOptions {
  int pixels = 128;  ///< width and height of a silhouette image, in pixels
};

/// Computes the light field descriptor (Chen, Tian, Shen, Ouhyoung 2003): SilhouetteFeatures, as integers from 0 to
/// 255, of silhouettes from the vertices of ten rotated dodecahedra. Only half of the vertices are used, because
/// opposite silhouettes are mirror images. The shape's centroid is at the centre of the image, and its bounding ball
/// touches the image's sides. Open, broken and non-manifold meshes are accepted; point clouds are rendered as splats
/// (surface_mesh()). Returns 4,500 numbers: 10 dodecahedra x 10 views x 45 features. Throws InputError for options out
/// of range, an unusable shape, and one without area.
Eigen::VectorXf light_field(const Shape& shape, const LightFieldOptions& options = {});

/// Computes the distance between the light fields of two shapes: the minimum, over all pairs of dodecahedra and all 60
/// rotations of a dodecahedron, of the sum of L1 distances between corresponding views, divided by 255.
double light_field_distance(std::span<const float> a, std::span<const float> b);

/// Returns the entry "light_field" of the registry descriptors().
Descriptor light_field_descriptor();

}  // namespace shapegauge
