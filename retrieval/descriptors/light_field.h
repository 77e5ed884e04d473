#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// To be raised with every change of light_field() or its distance that changes a value.
inline constexpr int light_field_version = 3;

/// Settings of light_field().
struct LightFieldOptions {
  int pixels = 128;  ///< of a silhouette's side
};

/// The light field descriptor (Chen, Tian, Shen, Ouhyoung 2003): silhouettes from the vertices of ten dodecahedra,
/// turned against each other (the vertices' halves: silhouettes from opposite sides are mirror images), and of each its
/// features (SilhouetteFeatures), as whole numbers from 0 to 255. The shape lies with its centroid in the middle, in
/// the ball that touches the image's sides. Open, broken and non-manifold meshes have silhouettes too; point clouds
/// those of their splats (splatted()). 4,500 numbers: sets x views x features. Throws InputError for options out of
/// range, an unusable shape, and one without area.
Eigen::VectorXf light_field(const Shape& shape, const LightFieldOptions& options = {});

/// The least sum of L1 distances between the views of a set of the one and a set of the other shape, over all pairs of
/// sets and all 60 rotations of the dodecahedron, over 255.
double light_field_distance(std::span<const float> a, std::span<const float> b);

Descriptor light_field_descriptor();

}  // namespace shapegauge
