// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/centricity.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <fmt/format.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

namespace {

/// Vertices of positive area with their areas.
struct Sites {
  std::vector<std::int32_t> vertices;
  Eigen::VectorXd areas;
};

Sites sites_of(const Samples& at_vertices) {
  Sites sites;
  for (Eigen::Index v = 0; v < at_vertices.weights.size(); ++v) {
    if (at_vertices.weights[v] > 0) sites.vertices.push_back(static_cast<std::int32_t>(v));
  }
  if (sites.vertices.empty())
    throw InputError(
        "the field centricity needs a shape with area; check it for degenerate triangles or coincident points");
  sites.areas = at_vertices.weights(sites.vertices);
  return sites;
}

/// Returns the site farthest from the centroid, which depends on the shape only.
std::int32_t outermost(const Points& points, const Sites& sites) {
  const Points of_sites = points(sites.vertices, Eigen::all);
  const Eigen::RowVector3d centroid = sites.areas.transpose() * of_sites / sites.areas.sum();
  Eigen::Index farthest = 0;
  (of_sites.rowwise() - centroid).rowwise().squaredNorm().maxCoeff(&farthest);
  return sites.vertices[static_cast<std::size_t>(farthest)];
}

/// Distances from landmarks in farthest-point order, one landmark per column, with their Voronoi areas.
struct Landmarks {
  Eigen::MatrixXd distances;
  Eigen::VectorXd areas;
};

Landmarks landmarks_of(const Shape& shape, const CentricityOptions& options) {
  const Samples at_vertices = sample_shape(shape, SampleSite::vertices);
  const Sites sites = sites_of(at_vertices);
  const GeodesicDistances distances_from = geodesic_distances(shape, options.geodesics);
  const auto farthest = [&](const Eigen::VectorXd& distances) {
    Eigen::Index index = 0;
    const double largest = distances(sites.vertices).maxCoeff<Eigen::PropagateNumbers>(&index);
    return std::pair(sites.vertices[static_cast<std::size_t>(index)], largest);
  };
  std::int32_t source = farthest(distances_from(outermost(at_vertices.points, sites))).first;
  const Eigen::Index most = std::min<Eigen::Index>(options.sources, std::ssize(sites.vertices));
  Landmarks landmarks{Eigen::MatrixXd(shape.vertices.rows(), most), Eigen::VectorXd::Zero(most)};
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(shape.vertices.rows(), std::numeric_limits<double>::infinity());
  std::vector<Eigen::Index> nearest_source(static_cast<std::size_t>(shape.vertices.rows()), 0);
  Eigen::Index count = 0;
  while (count < most) {
    check_interruption();
    const Eigen::VectorXd distances = distances_from(source);
    landmarks.distances.col(count) = distances;
    for (const std::int32_t v : sites.vertices) {
      if (!(distances[v] < nearest[v])) continue;
      nearest[v] = distances[v];
      nearest_source[static_cast<std::size_t>(v)] = count;
    }
    ++count;
    const auto [next, largest] = farthest(nearest);
    if (!(largest > 0)) break;  // all sites are sources, or coincide with some
    source = next;
  }
  landmarks.distances.conservativeResize(Eigen::NoChange, count);
  landmarks.areas.conservativeResize(count);
  for (std::size_t i = 0; i < sites.vertices.size(); ++i) {
    const auto v = static_cast<std::size_t>(sites.vertices[i]);
    landmarks.areas[nearest_source[v]] += sites.areas[static_cast<Eigen::Index>(i)];
  }
  return landmarks;
}

/// Returns the barycentric coordinates of a triangle's point; those of the centroid for a degenerate triangle.
Eigen::RowVector3d barycentric(const Shape& shape, Eigen::Index triangle, const Eigen::RowVector3d& point) {
  const Eigen::RowVector3d a = shape.vertices.row(shape.triangles(triangle, 0));
  const Eigen::RowVector3d ab = shape.vertices.row(shape.triangles(triangle, 1)) - a;
  const Eigen::RowVector3d ac = shape.vertices.row(shape.triangles(triangle, 2)) - a;
  const Eigen::RowVector3d ap = point - a;
  const Eigen::RowVector3d normal = ab.cross(ac);
  const double square = normal.squaredNorm();
  const double of_b = ap.cross(ac).dot(normal) / square;
  const double of_c = ab.cross(ap).dot(normal) / square;
  const Eigen::RowVector3d weights(1 - of_b - of_c, of_b, of_c);
  if (!weights.allFinite()) return Eigen::RowVector3d::Constant(1.0 / 3);
  return weights.cwiseMax(0) / weights.cwiseMax(0).sum();
}

[[noreturn]] void refuse(const Shape& shape, const Samples& samples, Eigen::Index expected) {
  throw InputError(fmt::format("the samples are not those of the shape, which has {} vertices: {} samples, expected {}",
                               shape.vertices.rows(), samples.points.rows(), expected));
}

/// Interpolates values to samples at a cloud's points.
Eigen::MatrixXd at_points(const Shape& cloud, const Samples& samples, const Eigen::MatrixXd& at_vertices) {
  const std::vector<std::int32_t> points = nearest_points(samples.points, cloud.vertices);
  if (cloud.vertices(points, Eigen::all) != samples.points) refuse(cloud, samples, cloud.vertices.rows());
  return at_vertices(points, Eigen::all);
}

}  // namespace

Eigen::MatrixXd interpolate_to_samples(const Shape& shape, const Samples& samples, const Eigen::MatrixXd& at_vertices) {
  const bool at_faces = samples.site == SampleSite::faces && !is_cloud(shape);
  const bool on_triangles = samples.site == SampleSite::surface && !is_cloud(shape);
  const Eigen::Index expected = at_faces       ? shape.triangles.rows()
                                : on_triangles ? std::ssize(samples.triangles)
                                               : shape.vertices.rows();
  const bool some_points = is_cloud(shape) && samples.points.rows() < expected;
  if ((samples.points.rows() != expected && !some_points) || at_vertices.rows() != shape.vertices.rows()) {
    refuse(shape, samples, expected);
  }
  if (some_points) return at_points(shape, samples, at_vertices);
  if (!at_faces && !on_triangles) return at_vertices;
  Eigen::MatrixXd values(expected, at_vertices.cols());
  for (Eigen::Index i = 0; i < expected; ++i) {
    const Eigen::Index triangle = at_faces ? i : samples.triangles[static_cast<std::size_t>(i)];
    const Eigen::RowVector3d weights =
        at_faces ? Eigen::RowVector3d::Constant(1.0 / 3) : barycentric(shape, triangle, samples.points.row(i));
    values.row(i) = weights[0] * at_vertices.row(shape.triangles(triangle, 0)) +
                    weights[1] * at_vertices.row(shape.triangles(triangle, 1)) +
                    weights[2] * at_vertices.row(shape.triangles(triangle, 2));
  }
  return values;
}

Eigen::VectorXd centricity(const Shape& shape, const Samples& samples, const CentricityOptions& options) {
  check_options("centricity", centricity_table, options);
  const Landmarks landmarks = landmarks_of(shape, options);
  const Eigen::VectorXd values = options.measure == Centricity::mean
                                     ? Eigen::VectorXd(landmarks.distances * landmarks.areas / landmarks.areas.sum())
                                     : Eigen::VectorXd(landmarks.distances.rowwise().maxCoeff());
  return interpolate_to_samples(shape, samples, values);
}

Eigen::VectorXd centricity(const ProxyGeodesics& geodesics, Centricity measure) {
  const Eigen::MatrixXf& distances = geodesics.distances;
  if (measure == Centricity::eccentricity) return distances.rowwise().maxCoeff().cast<double>();
  return distances.cast<double>() * (geodesics.areas / geodesics.areas.sum());
}

}  // namespace shapegauge
