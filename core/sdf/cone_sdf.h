#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Raised with every change of cone_sdf() that changes a value, which makes cached results of earlier versions stale.
inline constexpr int cone_sdf_version = 3;

/// Who casts the rays: CGAL's own `sdf_values` (the reference) or the same definition on Embree.
enum class ConeSdfEngine { embree, cgal };
template <>
inline constexpr std::array<std::string_view, 2> words_of<ConeSdfEngine>{"embree", "cgal"};

/// Settings of the conventional SDF: a cone of rays about the inward normal.
struct ConeSdfOptions {
  ConeSdfEngine engine = ConeSdfEngine::embree;
  double opening_angle_degrees = 60;
  int rays = 25;
  bool postprocess = false;  ///< CGAL's: fill the missing values, smooth, scale to [0, 1]; only with the cgal engine
  bool parallel = true;      ///< spread the samples over the threads of the calling TBB arena
};

/// What may be chosen of ConeSdfOptions.
inline constexpr std::array cone_sdf_table = {
    option_of<&ConeSdfOptions::engine>(
        "engine", "Who casts the rays: embree is fast; cgal is CGAL's own, the reference, at faces only."),
    option_of<&ConeSdfOptions::opening_angle_degrees>("opening_angle_degrees",
                                                      {.low = 0, .high = 180, .low_open = true, .high_open = true},
                                                      "Full opening angle of the cone."),
    option_of<&ConeSdfOptions::rays>("rays", {.low = 1, .high = 10'000}, "Number of rays."),
    option_of<&ConeSdfOptions::postprocess>(
        "postprocess", "CGAL's post-processing: smoothed and scaled to [0, 1] shape by shape; engine cgal only."),
};

/// The conventional SDF, sample by sample.
struct ConeSdfResult {
  Eigen::VectorXd values;    ///< in the shape's units; NaN where no ray gave an answer
  std::size_t missing = 0;   ///< how many are NaN
  double build_seconds = 0;  ///< spatial structures
  double query_seconds = 0;  ///< all samples
};

/// Conventional SDF at the given samples of the shape (Shapira et al. 2008, with the choices of CGAL 5.5;
/// docs/reference/definitions.md#conventional-sdf).
///
/// From each sample, rays go out in a cone about the inward normal, denser near its axis; they pass through the
/// triangles that touch the sample. Of each ray the nearest hit counts, and only if the ray leaves the shape there (the
/// triangle's normal is within 90 degrees of the ray). The value is the mean of the distances that lie within 1.5
/// median absolute deviations of their median. There is none (NaN) where the sample has no normal or no ray counts: on
/// faces turned inwards, for example. Doubled triangles have the value of their first, and stop no ray.
///
/// The engines cast the same rays. cgal answers at faces only, on one thread, and needs an oriented manifold; `samples`
/// then says where, not what. With embree, what is closer to the sample than 2^-22 diagonals touches it. The same input
/// gives the same bytes on any number of threads. Throws InputError for options out of range, a shape without triangles
/// or otherwise unusable (require_usable()), samples that are not the shape's, and a mesh that the cgal engine cannot
/// use.
ConeSdfResult cone_sdf(const Shape& shape, const Samples& samples, const ConeSdfOptions& options);

}  // namespace shapegauge
