// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/thick_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/render/splats.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

namespace {

constexpr double max_missing = 0.25;       ///< share of the area
constexpr double min_thickness = 1e-4;     ///< in units
constexpr double default_thickness = 0.1;  ///< in units, where nothing is known
constexpr double smoothing_width = 0.012;  ///< of normals, in units
constexpr int max_smoothing_rounds = 30;
constexpr int thickness_rounds = 3;
constexpr double same_thickness = 0.3;  ///< difference of logarithms beyond which neighbours do not count

double missing_area(const Eigen::VectorXd& values, const Samples& samples) {
  double area = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) area += values[i] > 0 ? 0 : samples.weights[i];
  return area;
}

/// Computes diameters in the shape's units, not positive or NaN if missing; turns the samples' normals outwards.
Eigen::VectorXd diameters(const Shape& shape, Samples& samples) {
  if (!is_cloud(shape)) {
    Eigen::VectorXd values = cone_sdf(shape, samples, {}).values;
    if (missing_area(values, samples) <= max_missing * samples.weights.sum()) return values;
  }
  OffsetSdfOptions options;
  options.offset = automatic_offset(shape).offset;
  OffsetSdfResult result = offset_sdf(shape, samples, options);
  samples.normals = std::move(result.normals);
  return std::move(result.values);
}

/// Fills missing values (NaN) by the mean of neighbours, ring by ring.
void fill(Eigen::VectorXd& values, const SurfaceGraph& graph) {
  std::vector<std::int32_t> missing;
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    if (std::isnan(values[i])) missing.push_back(i);
  }
  while (!missing.empty()) {
    std::vector<std::pair<std::int32_t, double>> found;
    for (const std::int32_t i : missing) {
      double sum = 0;
      int count = 0;
      for (const SurfaceLink& link : graph.links_of(i)) {
        if (std::isnan(values[link.to])) continue;
        sum += values[link.to];
        ++count;
      }
      if (count > 0) found.emplace_back(i, sum / count);
    }
    if (found.empty()) break;
    for (const auto& [i, value] : found) values[i] = value;
    std::erase_if(missing, [&](std::int32_t i) { return !std::isnan(values[i]); });
  }
  for (const std::int32_t i : missing) values[i] = std::log(default_thickness);
}

/// Averages values with those of neighbours, with weights that decrease with their difference.
Eigen::VectorXd smoothed(const Eigen::VectorXd& values, const SurfaceGraph& graph) {
  Eigen::VectorXd result(values.size());
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    double sum = values[i];
    double weights = 1;
    for (const SurfaceLink& link : graph.links_of(i)) {
      const double difference = (values[link.to] - values[i]) / same_thickness;
      const double weight = std::exp(-difference * difference);
      sum += weight * values[link.to];
      weights += weight;
    }
    result[i] = sum / weights;
  }
  return result;
}

/// Returns the number of averaging rounds whose reach, that of a random walk, is the smoothing width.
int smoothing_rounds(const SurfaceGraph& graph, double unit) {
  if (graph.links.empty()) return 0;
  double sum = 0;
  for (const SurfaceLink& link : graph.links) sum += link.distance;
  const double steps = smoothing_width * unit * static_cast<double>(graph.links.size()) / sum;
  return static_cast<int>(std::min<double>(max_smoothing_rounds, steps * steps));
}

Points smoothed_normals(const SurfaceGraph& graph, double unit) {
  Points normals = graph.samples.normals;
  const Eigen::VectorXd& weights = graph.samples.weights;
  for (int round = smoothing_rounds(graph, unit); round > 0; --round) {
    check_interruption();
    Points next = normals;
    for (std::int32_t i = 0; i < graph.size(); ++i) {
      Eigen::RowVector3d sum = normals.row(i) * weights[i];
      for (const SurfaceLink& link : graph.links_of(i)) {
        const double agreement = normals.row(link.to).dot(normals.row(i));
        if (agreement > 0) sum += normals.row(link.to) * (weights[link.to] * agreement);
      }
      const double length = sum.norm();
      if (length > 0) next.row(i) = sum / length;
    }
    normals = std::move(next);
  }
  return normals;
}

}  // namespace

Shape orient_outward(Shape shape) {
  if (is_closed_and_oriented(shape) && signed_volume(shape) < 0) shape.triangles.col(1).swap(shape.triangles.col(2));
  return shape;
}

double ThickSurface::normal_angle(std::int32_t node, const SurfaceLink& link) const {
  const Eigen::RowVector3d from = smooth_normals.row(node);
  const Eigen::RowVector3d to = smooth_normals.row(link.to);
  const double angle = std::acos(std::clamp(from.dot(to), -1.0, 1.0));
  const Eigen::RowVector3d way = graph.samples.points.row(link.to) - graph.samples.points.row(node);
  return (from - to).dot(way) > 0 ? angle : -angle;
}

ThickSurface thick_surface(const Shape& original) {
  const Shape shape = orient_outward(original);
  ThickSurface surface;
  surface.graph = surface_graph(shape);
  const double area = surface.graph.samples.weights.sum();
  if (!(area > 0 && std::isfinite(area)))
    throw InputError(
        "a shape without area cannot be segmented; check it for degenerate triangles or coincident points");
  surface.unit = std::sqrt(area);
  const Eigen::VectorXd diameter = diameters(shape, surface.graph.samples);
  surface.log_thickness = diameter.unaryExpr([&](double d) {
    return d > 0 ? std::log(std::max(d / surface.unit, min_thickness)) : std::numeric_limits<double>::quiet_NaN();
  });
  fill(surface.log_thickness, surface.graph);
  for (int round = 0; round < thickness_rounds; ++round) {
    check_interruption();
    surface.log_thickness = smoothed(surface.log_thickness, surface.graph);
  }
  surface.smooth_normals = smoothed_normals(surface.graph, surface.unit);
  surface.barrier = is_cloud(shape) ? splats(shape) : shape;
  surface.barrier_triangles_per_node = is_cloud(shape) ? triangles_per_splat : 1;
  return surface;
}

}  // namespace shapegauge
