// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of cone_sdf(); increment when results change (docs/manual/cache.md).
inline constexpr int cone_sdf_version = 3;

/// Ray-casting backend of cone_sdf(): Embree, or CGAL's own `sdf_values` as the reference.
enum class ConeSdfEngine { embree, cgal };
template <>
inline constexpr std::array<std::string_view, 2> words_of<ConeSdfEngine>{"embree", "cgal"};

/// Options of the conventional SDF, which casts a cone of rays about the inward normal.
struct ConeSdfOptions {
  ConeSdfEngine engine = ConeSdfEngine::embree;  ///< ray-casting backend
  double opening_angle_degrees = 60;             ///< full opening angle of the cone
  int rays = 25;                                 ///< number of rays per sample
  bool postprocess = false;  ///< fill missing values, smooth and scale to [0, 1], as CGAL does; engine cgal only
  bool parallel = true;      ///< distribute the samples over the threads of the calling TBB arena
};

/// Names, bounds and help texts of the parameters in ConeSdfOptions (option_parameters.h).
inline constexpr std::array cone_sdf_table = {
    option_of<&ConeSdfOptions::engine>(
        "engine", "Ray-casting backend. embree: fast; cgal: CGAL's implementation, at faces only."),
    with_unit("degrees", option_of<&ConeSdfOptions::opening_angle_degrees>(
                             "opening_angle_degrees", {.low = 0, .high = 180, .low_open = true, .high_open = true},
                             "Full opening angle of the ray cone.")),
    option_of<&ConeSdfOptions::rays>("rays", {.low = 1, .high = 10'000},
                                     "Number of rays per sample; more rays are more precise, but slower."),
    option_of<&ConeSdfOptions::postprocess>("postprocess",
                                            "Smooth the values and scale them to [0, 1] per shape; engine cgal only."),
};

/// Result of cone_sdf(): the conventional SDF (shape diameter function), one value per sample.
struct ConeSdfResult {
  Eigen::VectorXd values;    ///< SDF per sample, in the shape's units; NaN if no ray of the sample is valid
  std::size_t missing = 0;   ///< number of samples whose value is NaN
  double build_seconds = 0;  ///< time for the construction of spatial structures, in seconds
  double query_seconds = 0;  ///< time for the queries of all samples, in seconds
};

/// Computes the conventional SDF at samples of a shape (Shapira et al. 2008, with the choices of CGAL 5.5;
/// docs/reference/definitions.md#conventional-sdf).
///
/// From each sample, rays are cast in a cone about the inward normal, more densely near its axis. They pass through the
/// triangles that touch the sample. A ray is valid if it leaves the shape at its nearest hit: the triangle's normal is
/// within 90 degrees of the ray. The value is the mean of the distances within 1.5 median absolute deviations of their
/// median. It is missing (NaN) if the sample has no normal or no ray is valid, for example on inward-facing faces.
/// A duplicate triangle has the value of its first copy and stops no ray.
///
/// Both engines cast the same rays. cgal supports faces only, runs on one thread and needs an oriented manifold; it
/// ignores the positions of `samples` and computes one value per face. With embree, triangles closer than 2^-22
/// diagonals touch the sample. The same input gives the same bytes on any number of threads.
///
/// Throws InputError for options out of range, a shape without triangles or otherwise unusable (require_usable()),
/// samples of another shape, and a mesh that the cgal engine does not support.
ConeSdfResult cone_sdf(const Shape& shape, const Samples& samples, const ConeSdfOptions& options);

}  // namespace shapegauge
