// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/proxy/surface_proxy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/median.h"
#include "shapegauge/core/proxy/dense_samples.h"
#include "shapegauge/core/proxy/farthest_points.h"
#include "shapegauge/core/proxy/local_connectivity.h"
#include "shapegauge/core/proxy/local_delaunay.h"
#include "shapegauge/core/proxy/sample_connectivity.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/link_components.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

namespace {

constexpr Eigen::Index samples_per_point = 12;
constexpr int candidate_neighbours = 20;  ///< of a point, among which its neighbours are chosen

/// Samples chosen as points of a proxy, before neighbours are computed.
struct ProxyPoints {
  DenseSamples at;                    ///< with the areas and mean normals of the samples that each point covers
  std::vector<std::int32_t> samples;  ///< sample chosen for each point
  double covering_radius;
};

/// Computes the areas and mean normals of the samples covered by each chosen one.
ProxyPoints proxy_points(const DenseSamples& samples, const FarthestPoints& farthest) {
  const Eigen::Index count = std::ssize(farthest.chosen);
  ProxyPoints proxy{
      {samples.points(farthest.chosen, Eigen::all), Points::Zero(count, 3), Eigen::VectorXd::Zero(count), {}, {}},
      farthest.chosen,
      farthest.covering_radius};
  for (const std::int32_t sample : farthest.chosen) {
    proxy.at.sheets.push_back(samples.sheets[static_cast<std::size_t>(sample)]);
    if (!samples.triangles.empty()) proxy.at.triangles.push_back(samples.triangles[static_cast<std::size_t>(sample)]);
  }
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    const std::int32_t point = farthest.nearest[static_cast<std::size_t>(i)];
    const Eigen::RowVector3d normal = samples.normals.row(farthest.chosen[static_cast<std::size_t>(point)]);
    const double sign = normal.dot(samples.normals.row(i)) < 0 ? -1 : 1;
    proxy.at.areas[point] += samples.areas[i];
    proxy.at.normals.row(point) += sign * samples.areas[i] * samples.normals.row(i);
  }
  for (Eigen::Index i = 0; i < count; ++i) proxy.at.normals.row(i).normalize();
  return proxy;
}

/// Returns half of the median distance to the sixth neighbour, a lower bound of the covering radius of farthest points.
/// Used for clouds of hardly more points than the proxy, whose covering radius is 0.
double radius_of_spacing(const Points& points) {
  if (points.rows() < 2) return 0;
  const PointNeighbours nearest = nearest_neighbours(points, std::min<int>(6, static_cast<int>(points.rows()) - 1));
  std::vector<double> distances(static_cast<std::size_t>(points.rows()));
  for (std::size_t i = 0; i < distances.size(); ++i) {
    distances[i] = nearest.distances(static_cast<Eigen::Index>(i), nearest.distances.cols() - 1);
  }
  return upper_median(distances) / 2;
}

/// Tests whether neighbouring points are connected along the surface between them. Touching parts are close in space
/// but far apart along the surface.
class PointConnectivity {
 public:
  PointConnectivity(const ProxyPoints& proxy, const DenseSamples& samples, LocalConnectivity triangles)
      : proxy_(proxy), samples_(samples), across_triangles_(std::move(triangles)) {}

  /// Returns true if a path connects two points in the ball about their midpoint; an arc that turns by less than half a
  /// circle lies inside. The path crosses triangles of a component of a mesh; elsewhere it passes through samples.
  bool connected(std::int32_t i, std::int32_t j, double distance) {
    const Eigen::Vector3d midpoint = (proxy_.at.points.row(i) + proxy_.at.points.row(j)).transpose() / 2;
    if (proxy_.at.triangles.empty()) return through_samples(i, j, midpoint, distance);
    const std::int32_t from = proxy_.at.triangles[static_cast<std::size_t>(i)];
    const std::int32_t to = proxy_.at.triangles[static_cast<std::size_t>(j)];
    if (from == to) return true;
    if (!across_triangles_.in_same_component(from, to)) return through_samples(i, j, midpoint, distance);
    if (across_triangles_.connected_in_ball(from, to, midpoint, distance / 2)) return true;
    return across_triangles_.has_visited_boundary() &&
           across_triangles_.connected_in_ball(from, to, midpoint, distance, SharedElement::vertex);
  }

 private:
  bool through_samples(std::int32_t i, std::int32_t j, const Eigen::Vector3d& midpoint, double distance) {
    if (!across_samples_) across_samples_.emplace(samples_);
    return across_samples_->connected_in_ball(proxy_.samples[static_cast<std::size_t>(i)],
                                              proxy_.samples[static_cast<std::size_t>(j)], midpoint, distance);
  }

  const ProxyPoints& proxy_;
  const DenseSamples& samples_;
  LocalConnectivity across_triangles_;
  std::optional<SampleConnectivity> across_samples_;  ///< made when first needed
};

/// Returns each pair of neighbours once, the smaller point first.
std::vector<Segment> neighbour_pairs(const ProxyPoints& proxy, PointConnectivity connectivity, int neighbours) {
  const PointNeighbours nearest = nearest_neighbours(proxy.at.points, neighbours);
  const double reach = 2.5 * proxy.covering_radius;
  std::vector<Segment> candidates;  // from a point to one of its nearest: most pairs occur in both directions
  for (std::int32_t i = 0; i < nearest.indices.rows(); ++i) {
    for (Eigen::Index k = 0; k < nearest.indices.cols(); ++k) {
      const std::int32_t j = nearest.indices(i, k);
      const double distance = nearest.distances(i, k);
      if (distance > 0 && distance <= reach && on_same_sheet(proxy.at, i, j, distance)) {
        candidates.push_back({i, j, distance});
      }
    }
  }
  std::ranges::sort(candidates, {}, [](const Segment& pair) {
    return std::tuple(std::min(pair.a, pair.b), std::max(pair.a, pair.b), pair.a);
  });
  std::vector<Segment> pairs;
  for (const auto& [i, j, distance] : candidates) {
    const Segment pair{std::min(i, j), std::max(i, j), distance};
    const bool is_known = !pairs.empty() && pairs.back().a == pair.a && pairs.back().b == pair.b;
    if (!is_known && connectivity.connected(i, j, distance)) pairs.push_back(pair);
  }
  return pairs;
}

/// Fixes the sign of unoriented normals independently of the orientation of faces.
Points unsigned_normals(Points normals) {
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    auto normal = normals.row(i);
    const double first = normal[0] != 0 ? normal[0] : normal[1] != 0 ? normal[1] : normal[2];
    if (first < 0) normal = -normal;
  }
  return normals;
}

void set_arcs(SurfaceProxy& proxy, const std::vector<Segment>& segments) {
  const auto count = static_cast<std::size_t>(proxy.points.rows());
  std::vector<std::pair<std::int32_t, ProxyArc>> arcs;
  for (const Segment& segment : segments) {
    const auto length = static_cast<float>(segment.length);
    arcs.push_back({segment.a, {segment.b, length}});
    arcs.push_back({segment.b, {segment.a, length}});
  }
  const auto sorted = bucket_sort(arcs, count, [](const auto& arc) { return arc.first; });
  proxy.first_arc = sorted.first;
  for (const auto& [from, arc] : sorted.values) proxy.arcs.push_back(arc);
}

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_weight(Triplets& weights, std::int32_t i, std::int32_t j, double weight) {
  weights.emplace_back(i, j, weight);
  weights.emplace_back(j, i, weight);
}

/// Returns a point's neighbours in its tangent plane, at their distances from it.
std::vector<Eigen::Vector2d> in_tangent_plane(const SurfaceProxy& proxy, std::size_t point) {
  const auto row = static_cast<Eigen::Index>(point);
  const Eigen::Vector3d normal = proxy.normals.row(row).transpose();
  const Eigen::Vector3d x = normal.unitOrthogonal();
  const Eigen::Vector3d y = normal.cross(x);
  std::vector<Eigen::Vector2d> flat;
  for (const ProxyArc& arc : proxy.arcs_of(point)) {
    const Eigen::Vector3d offset = (proxy.points.row(arc.to) - proxy.points.row(row)).transpose();
    const Eigen::Vector2d projected(offset.dot(x), offset.dot(y));
    const double length = projected.norm();
    flat.push_back(length > 0 ? Eigen::Vector2d(projected * (arc.length / length)) : Eigen::Vector2d(arc.length, 0));
  }
  return flat;
}

double twice_area(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
  return std::abs(u.x() * v.y() - u.y() * v.x());
}

/// Returns the cotangent of the angle between two vectors.
double cotangent(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
  constexpr double bound = 1e3;
  const double product = u.dot(v);
  return std::abs(product) < bound * twice_area(u, v) ? product / twice_area(u, v) : std::copysign(bound, product);
}

/// Delaunay triangles about a point in its tangent plane.
struct Star {
  std::vector<Eigen::Vector2d> flat;                   ///< the point's neighbours
  std::vector<std::array<std::int32_t, 2>> triangles;  ///< the other two corners of each
};

/// Builds the star of a point. Excludes triangles with circumcircles much larger than the covering radius, which span a
/// wide hole or the boundary: slivers along boundaries would distort the weights.
Star star_of(const SurfaceProxy& proxy, std::size_t point) {
  Star star{.flat = in_tangent_plane(proxy, point), .triangles = {}};
  for (const auto& triangle : delaunay_star(star.flat)) {
    const Eigen::Vector2d& u = star.flat[static_cast<std::size_t>(triangle[0])];
    const Eigen::Vector2d& v = star.flat[static_cast<std::size_t>(triangle[1])];
    const double radius = u.norm() * v.norm() * (u - v).norm() / (2 * twice_area(u, v));
    if (!(radius <= 2.5 * proxy.covering_radius)) continue;
    star.triangles.push_back(triangle);
  }
  return star;
}

/// Assembles a third of the cotangent weights of the triangles about each point.
Triplets cotangent_weights(const SurfaceProxy& proxy) {
  Triplets weights;
  const SparseInterruptionCheck check;
  for (std::size_t i = 0; i + 1 < proxy.first_arc.size(); ++i) {
    check();
    const auto point = static_cast<std::int32_t>(i);
    const std::span<const ProxyArc> arcs = proxy.arcs_of(i);
    const Star star = star_of(proxy, i);
    for (const auto& [a, b] : star.triangles) {
      const Eigen::Vector2d& u = star.flat[static_cast<std::size_t>(a)];
      const Eigen::Vector2d& v = star.flat[static_cast<std::size_t>(b)];
      const std::int32_t j = arcs[static_cast<std::size_t>(a)].to;
      const std::int32_t k = arcs[static_cast<std::size_t>(b)].to;
      add_weight(weights, j, k, cotangent(u, v) / 6);
      add_weight(weights, point, k, cotangent(-u, v - u) / 6);
      add_weight(weights, point, j, cotangent(-v, u - v) / 6);
    }
  }
  return weights;
}

/// Assembles the graph Laplacian of the summed weights, with negative ones set to 0. Segments without weights (links,
/// and parts too thin for triangles) get those of a regular triangulation, less across wide gaps.
Eigen::SparseMatrix<double> stiffness_of(const SurfaceProxy& proxy, std::span<const Segment> segments) {
  constexpr double min_joining = 0.01;
  const Eigen::Index count = proxy.points.rows();
  Triplets entries = cotangent_weights(proxy);
  Eigen::SparseMatrix<double> weights(count, count);
  weights.setFromTriplets(entries.begin(), entries.end());
  entries.clear();
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(count);
  DisjointSets pieces;
  pieces.grow_to(static_cast<std::size_t>(count));
  const auto add = [&](Eigen::Index i, Eigen::Index j, double weight) {
    entries.emplace_back(i, j, -weight);
    sums[i] += weight;
  };
  for (Eigen::Index column = 0; column < count; ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(weights, column); entry; ++entry) {
      if (!(entry.value() > 0)) continue;
      add(entry.row(), column, entry.value());
      if (entry.value() < min_joining) continue;
      pieces.join(static_cast<std::int32_t>(entry.row()), static_cast<std::int32_t>(column));
    }
  }
  for (const Segment& segment : segments) {
    if (pieces.find(segment.a) == pieces.find(segment.b)) continue;
    const double weight = std::min(1.0, proxy.covering_radius / segment.length) / std::numbers::sqrt3;
    add(segment.a, segment.b, weight);
    add(segment.b, segment.a, weight);
  }
  for (Eigen::Index i = 0; i < count; ++i) entries.emplace_back(i, i, sums[i]);
  Eigen::SparseMatrix<double> stiffness(count, count);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

}  // namespace

SurfaceProxy surface_proxy(const Shape& shape, Eigen::Index points) {
  require_usable(shape);
  const UnitFrame frame = unit_frame(shape);
  const Shape framed = in_unit_frame(shape, frame);
  const std::vector<std::int32_t> merged = welded_vertices(framed.vertices);
  const std::vector<HalfEdge> uses = half_edges(framed.triangles, merged);
  const DenseSamples samples = dense_samples(framed, uses, samples_per_point * points);
  ProxyPoints chosen = proxy_points(samples, farthest_points(samples, points));
  chosen.covering_radius = std::max(chosen.covering_radius, radius_of_spacing(chosen.at.points));
  SurfaceProxy proxy;
  proxy.points = chosen.at.points;
  proxy.normals = unsigned_normals(chosen.at.normals);
  proxy.areas = chosen.at.areas;
  proxy.covering_radius = chosen.covering_radius;
  std::vector<Segment> segments = neighbour_pairs(
      chosen, PointConnectivity(chosen, samples, LocalConnectivity(framed, merged, uses)), candidate_neighbours);
  set_arcs(proxy, segments);
  proxy.components = link_components(proxy.points, 8, segments);
  proxy.stiffness = stiffness_of(proxy, segments);
  for (Segment& segment : segments) segment.length *= frame.diagonal;
  proxy.arcs.clear();
  set_arcs(proxy, segments);
  proxy.points = (proxy.points * frame.diagonal).rowwise() + frame.centre.transpose();
  proxy.areas *= frame.diagonal * frame.diagonal;
  proxy.covering_radius *= frame.diagonal;
  return proxy;
}

}  // namespace shapegauge
