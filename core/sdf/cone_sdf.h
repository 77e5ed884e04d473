#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Who casts the rays: CGAL's own `sdf_values` (the reference) or the same definition on Embree.
enum class ConeSdfEngine { embree, cgal };

/// Settings of the conventional SDF: a cone of rays about the inward normal.
struct ConeSdfOptions {
  ConeSdfEngine engine = ConeSdfEngine::embree;
  double opening_angle_degrees = 60;
  int rays = 25;
  bool postprocess = false;  ///< CGAL's: fill the missing values, smooth, scale to [0, 1]; only with the cgal engine
  bool parallel = true;      ///< spread the samples over the threads of the calling TBB arena
};

/// The conventional SDF, sample by sample.
struct ConeSdfResult {
  Eigen::VectorXd values;    ///< in the shape's units; NaN where no ray gave an answer
  std::size_t missing = 0;   ///< how many are NaN
  double build_seconds = 0;  ///< spatial structures
  double query_seconds = 0;  ///< all samples
};

/// Conventional SDF at the given samples of the shape (Shapira et al. 2008, with CGAL 5.5's choices; the design, section
/// 2.3). The cgal engine answers at faces only. Throws InputError for options out of range.
ConeSdfResult cone_sdf(const Shape& shape, const Samples& samples, const ConeSdfOptions& options);

}  // namespace shapegauge
