#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Where a field is sampled (the design, section 2.4).
enum class SampleSite { faces, vertices };

/// Sample points on a shape, in the order of the shape's triangles or vertices.
struct Samples {
  SampleSite site = SampleSite::faces;
  Points points;   ///< one sample a row, in the shape's units
  Points normals;  ///< unit normals by the triangles' orientation; zero where there is none (degenerate, unused)
  Eigen::VectorXd weights;  ///< area that the sample stands for; zero where there is none
};

/// Samples at the centroids of the triangles (weight: the triangle's area) or at the vertices (weight: the mixed
/// Voronoi area of Meyer et al. 2003; normal: the angle-weighted mean of the triangles' normals). Throws InputError
/// where the shape is unusable (validity.h).
Samples sample_shape(const Shape& shape, SampleSite site);

}  // namespace shapegauge
