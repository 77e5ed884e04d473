#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/geodesics.h"
#include "shapegauge/core/proxy/proxy_geodesics.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// To be raised with every change of centricity() that changes a value: what a cache holds of earlier versions is then
/// computed anew.
inline constexpr int centricity_version = 2;

/// What is taken of the geodesic distances from a place to all others.
enum class Centricity {
  mean,          ///< their mean over the surface, by area (Gal, Shamir, Cohen-Or 2007)
  eccentricity,  ///< the largest (Ion et al. 2007)
};

template <>
inline constexpr std::array<std::string_view, 2> words_of<Centricity>{"mean", "eccentricity"};

/// Settings of centricity().
struct CentricityOptions {
  Centricity measure = Centricity::mean;
  GeodesicOptions geodesics = {};
  int sources = 48;  ///< landmarks; all vertices where there are no more
};

/// What may be chosen of CentricityOptions.
inline constexpr std::array centricity_table = {
    option_of<&CentricityOptions::measure>("measure",
                                           "Of the distances to all places the mean, by area, or the largest."),
    option_within<&CentricityOptions::geodesics, geodesic_table, 0>(),
    option_within<&CentricityOptions::geodesics, geodesic_table, 1>(),
    option_of<&CentricityOptions::sources>(
        "sources", {.low = 1, .high = 1000},
        "Landmarks, spread over the surface, to which distances are taken; of the proxy always 500."),
};

/// Mean geodesic distance, or eccentricity, at the samples, in the shape's units: small in the middle of a shape, large
/// at its ends, and hardly changed where it bends.
///
/// Distances are taken from farthest points: the vertex that is geodesically farthest from the vertex farthest from the
/// centroid, then always the vertex farthest from those there are (ties: the first). In the mean each counts with the
/// area that is nearest to it. Values at vertices are interpolated to samples inside triangles. Components are joined
/// as geodesic_distances() says. NaN at vertices that no triangle uses.
///
/// A sphere of radius R has the mean pi R / 2 and the eccentricity pi R everywhere. Proportional to scale. Throws
/// InputError for options out of range, for samples that are not the shape's, for a shape without area, and as
/// geodesic_distances().
Eigen::VectorXd centricity(const Shape& shape, const Samples& samples, const CentricityOptions& options = {});

/// The same at the points of a surface proxy, from the distances to its landmarks.
Eigen::VectorXd centricity(const ProxyGeodesics& geodesics, Centricity measure);

/// Values at a shape's vertices, brought to samples of it: by barycentric coordinates where those lie inside triangles,
/// as they are where those are some of a cloud's points.
/// Throws InputError for samples that are not the shape's.
Eigen::MatrixXd at_samples(const Shape& shape, const Samples& samples, const Eigen::MatrixXd& at_vertices);

}  // namespace shapegauge
