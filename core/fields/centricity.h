// SPDX-License-Identifier: GPL-3.0-or-later
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

/// Cache version of centricity(); see docs/manual/cache.md.
inline constexpr int centricity_version = 2;

/// Statistic of the geodesic distances from a point to all others.
enum class Centricity {
  mean,          ///< area-weighted mean over the surface (Gal, Shamir, Cohen-Or 2007)
  eccentricity,  ///< maximum over the surface (Ion et al. 2007)
};

template <>
inline constexpr std::array<std::string_view, 2> words_of<Centricity>{"mean", "eccentricity"};

/// Options of centricity().
struct CentricityOptions {
  Centricity measure = Centricity::mean;  ///< statistic of the distances
  GeodesicOptions geodesics = {};         ///< algorithm for the distances
  int sources = 48;  ///< number of landmark vertices from which distances are measured; at most all vertices
};

/// Names, bounds and help texts of the parameters in CentricityOptions (option_parameters.h).
inline constexpr std::array centricity_table = {
    option_of<&CentricityOptions::measure>(
        "measure", "Statistic of the geodesic distances. mean: area-weighted mean; eccentricity: maximum."),
    nested_option<&CentricityOptions::geodesics, geodesic_table, 0>(),
    nested_option<&CentricityOptions::geodesics, geodesic_table, 1>(),
    option_of<&CentricityOptions::sources>(
        "sources", {.low = 1, .high = 1000},
        "Number of landmark vertices from which geodesic distances are measured; more are more precise. "
        "Ignored if `on` is proxy, which uses 500."),
};

/// Computes the centricity at the samples, in the shape's units: the mean geodesic distance to the rest of the surface,
/// or the largest (eccentricity). It is small in the middle of a shape, large at its ends, and nearly invariant to
/// bending.
///
/// Distances are measured from landmarks in farthest-point order. The first is the vertex geodesically farthest from
/// the vertex farthest from the centroid; each further one is the vertex farthest from the previous ones (ties: the
/// first vertex). The mean weights each landmark with the area of its geodesic Voronoi cell. Values at vertices are
/// interpolated to samples inside triangles. Components are connected as in geodesic_distances(). NaN at vertices that
/// no triangle uses.
///
/// On a sphere of radius R the mean is pi R / 2 and the eccentricity pi R everywhere. Proportional to scale. Throws
/// InputError for options out of range, samples of another shape, a shape without area, and as geodesic_distances()
/// does.
Eigen::VectorXd centricity(const Shape& shape, const Samples& samples, const CentricityOptions& options = {});

/// Computes the centricity (mean geodesic distance or eccentricity) at the points of a surface proxy, one value per
/// point, from their distances to the proxy's landmarks; in the shape's units.
Eigen::VectorXd centricity(const ProxyGeodesics& geodesics, Centricity measure);

/// Interpolates values at a shape's vertices (one row per vertex) to samples of the shape (one row per sample):
/// barycentrically for samples inside triangles, by lookup for samples at a cloud's points. Throws InputError for
/// samples of another shape.
Eigen::MatrixXd interpolate_to_samples(const Shape& shape, const Samples& samples, const Eigen::MatrixXd& at_vertices);

}  // namespace shapegauge
