// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/core/base/median.h"
#include "shapegauge/core/base/parallel_parts.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/sdf/cone_sdf_engines.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/spatial/morton_order.h"
#include "shapegauge/core/spatial/ray_caster.h"

namespace shapegauge {

namespace {

/// Batcher's odd-even merge sort (Knuth, The Art of Computer Programming, vol. 3, 5.2.2, algorithm M). Which values it
/// compares does not depend on them, so that it has no branches to mispredict: of 25 values it sorts three times as
/// fast as std::sort.
void sort_by_merge_exchange(std::span<double> values) {
  const std::size_t half = std::bit_ceil(values.size()) / 2;
  for (std::size_t p = half; p > 0; p /= 2) {
    std::size_t remainder = 0;
    std::size_t distance = p;
    for (std::size_t q = half; q >= p; q /= 2) {
      for (std::size_t i = 0; i + distance < values.size(); ++i) {
        if ((i & p) != remainder) continue;
        const double first = values[i];
        const double second = values[i + distance];
        values[i] = std::min(first, second);
        values[i + distance] = std::max(first, second);
      }
      distance = q - p;
      remainder = p;
    }
  }
}

/// The largest deviation from the centre among the `count` values closest to it. They follow each other in order.
double largest_of_closest(std::span<const double> sorted, double centre, std::size_t count) {
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first + count <= sorted.size(); ++first) {
    result = std::min(result, std::max(centre - sorted[first], sorted[first + count - 1] - centre));
  }
  return result;
}

double median_absolute_deviation(std::span<const double> sorted, double centre) {
  const std::size_t half = sorted.size() / 2;
  const double upper = largest_of_closest(sorted, centre, half + 1);
  return sorted.size() % 2 == 1 ? upper : (largest_of_closest(sorted, centre, half) + upper) / 2;
}

/// Unit directions of the rays about the axis (0, 0, 1): through the points of a Vogel spiral on the cone's base disk,
/// with radius i/N where sqrt(i/N) would be uniform, so that they are denser near the axis. The first is the axis.
std::vector<Eigen::Vector3d> cone_directions(const ConeSdfOptions& options) {
  const double half_angle = options.opening_angle_degrees / 360 * std::numbers::pi;
  const double golden_angle = (3 - std::sqrt(5.0)) * std::numbers::pi;
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < options.rays; ++i) {
    const double radius = std::sin(half_angle) * i / options.rays;
    const double turn = i * golden_angle;
    directions.emplace_back(
        Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), std::cos(half_angle)).normalized());
  }
  return directions;
}

/// Orthonormal frame whose third column is the unit vector `axis`. The other two are those of CGAL's planes, so that
/// both engines cast the same rays.
Eigen::Matrix3d frame_about(const Eigen::Vector3d& axis) {
  Eigen::Vector3d first;
  if (axis.x() == 0) {
    first = Eigen::Vector3d::UnitX();
  } else if (axis.y() == 0) {
    first = Eigen::Vector3d::UnitY();
  } else if (axis.z() == 0) {
    first = Eigen::Vector3d::UnitZ();
  } else {
    Eigen::Index smallest = 0;
    axis.cwiseAbs().minCoeff(&smallest);
    if (smallest == 0) first = Eigen::Vector3d(0, -axis.z(), axis.y()).normalized();
    if (smallest == 1) first = Eigen::Vector3d(-axis.z(), 0, axis.x()).normalized();
    if (smallest == 2) first = Eigen::Vector3d(-axis.y(), axis.x(), 0).normalized();
  }
  Eigen::Matrix3d frame;
  frame << first, axis.cross(first), axis;
  return frame;
}

/// For every sample the triangles that its rays start on: its own, or those with a corner where the vertex is.
class StartTriangles {
 public:
  StartTriangles(const Shape& shape, const Samples& samples) {
    if (samples.site != SampleSite::vertices) {
      triangles_ = samples.triangles;
      if (samples.site == SampleSite::faces) {
        triangles_.resize(static_cast<std::size_t>(shape.triangles.rows()));
        std::iota(triangles_.begin(), triangles_.end(), 0);
      }
      return;
    }
    group_ = welded_vertices(shape.vertices);  // a seam that doubles them does not end a ray where it starts
    std::vector<std::int32_t> corners(static_cast<std::size_t>(shape.triangles.size()));
    std::iota(corners.begin(), corners.end(), 0);
    const auto group_of = [&](std::int32_t corner) { return group_[shape.triangles(corner / 3, corner % 3)]; };
    const BucketSorted<std::int32_t> sorted = bucket_sort(corners, group_.size(), group_of);
    begin_ = sorted.first;
    for (const std::int32_t corner : sorted.values) triangles_.push_back(corner / 3);
  }

  [[nodiscard]] std::span<const std::int32_t> of(Eigen::Index sample) const {
    if (group_.empty()) return std::span(triangles_).subspan(sample, 1);
    const std::int32_t group = group_[sample];
    return std::span(triangles_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
  }

 private:
  std::vector<std::int32_t> group_;      // of every vertex; empty if each sample has one triangle
  std::vector<std::size_t> begin_;       // of every group, where its triangles begin
  std::vector<std::int32_t> triangles_;  // of all groups, or by sample
};

/// A ray that leaves through a face turned inwards says nothing of the inside.
bool leaves(const RayHit& hit) { return hit && hit.leaving; }

/// A second tree takes as long to build as its quicker rays save when there are so many for each triangle.
constexpr Eigen::Index rays_that_pay = 5;

/// Of the same shape, for most rays and for those that must not slip.
struct RayCasters {
  RayCasters(const Shape& shape, Eigen::Index rays) : without_gaps(shape, EdgeHandling::robust) {
    if (rays > rays_that_pay * shape.triangles.rows()) quick.emplace(shape, EdgeHandling::fast);
  }

  RayCaster without_gaps;
  std::optional<RayCaster> quick;  ///< nothing where it would not pay
};

/// Casts the cones of a shape, one at a time. Has scratch buffers for the rays of a cone: use one object per thread.
class Cones {
 public:
  Cones(const RayCasters& casters, std::span<const Eigen::Vector3d> directions)
      : casters_(casters),
        about_z_(directions),
        directions_(directions.size()),
        hits_(directions.size()),
        distances_(directions.size()) {}

  double sdf_at(const Eigen::Vector3d& point, const Eigen::Vector3d& inward, std::span<const std::int32_t> start) {
    const Eigen::Matrix3d frame = frame_about(inward);
    std::ranges::transform(about_z_, directions_.begin(),
                           [&](const Eigen::Vector3d& direction) -> Eigen::Vector3d { return frame * direction; });
    cast(point, start);
    std::size_t count = 0;
    for (const RayHit& hit : hits_) {
      if (leaves(hit)) distances_[count++] = hit.distance;
    }
    if (count == 0) return std::numeric_limits<double>::quiet_NaN();
    return mean_without_outliers(std::span(distances_).first(count));
  }

 private:
  /// Where the surface is closed and oriented, a ray that slips between two triangles shows: it does not leave. Such
  /// rays are cast again, without gaps. The ray along the axis is at once: symmetric shapes send it exactly through
  /// vertices and edges, and having slipped through two it would leave again.
  void cast(const Eigen::Vector3d& point, std::span<const std::int32_t> start) {
    const std::span<const Eigen::Vector3d> directions(directions_);
    const std::span<RayHit> hits(hits_);
    if (!casters_.quick) return casters_.without_gaps.first_hits(point, directions, start, hits);
    casters_.without_gaps.first_hits(point, directions.first(1), start, hits.first(1));
    casters_.quick->first_hits(point, directions.subspan(1), start, hits.subspan(1));
    // Slipping is rare: where more rays than a few do not leave, the surface is open there or turned.
    const std::size_t few = (hits.size() + 9) / 10;
    const auto leaving = static_cast<std::size_t>(std::ranges::count_if(hits, leaves));
    if (hits.size() - leaving > few) return;
    for (std::size_t i = 1; i < hits.size(); ++i) {
      if (!leaves(hits[i])) hits[i] = casters_.without_gaps.first_hit(point, directions[i], start);
    }
  }

  const RayCasters& casters_;
  std::span<const Eigen::Vector3d> about_z_;
  std::vector<Eigen::Vector3d> directions_;
  std::vector<RayHit> hits_;
  std::vector<double> distances_;
};

}  // namespace

double mean_without_outliers(std::span<double> values) {
  constexpr double accepted_deviations = 1.5;
  sort_by_merge_exchange(values);
  const double centre = sorted_median(values);
  const double limit = accepted_deviations * median_absolute_deviation(values, centre);
  double sum = 0;
  int count = 0;
  for (const double value : values) {
    if (std::abs(value - centre) > limit) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? sum / count : centre;
}

ConeSdfResult cone_sdf_embree(const Shape& shape, const Samples& samples, const ConeSdfOptions& options) {
  ConeSdfResult result;
  const Stopwatch building;
  const RayCasters casters(shape, samples.points.rows() * options.rays);
  const StartTriangles start_triangles(shape, samples);
  // Where a sample's rays go, its neighbour's went before: what they need of the tree is in the processor's cache.
  const std::vector<std::int32_t> order = morton_order(samples.points);
  const std::vector<Eigen::Vector3d> directions = cone_directions(options);
  result.build_seconds = building.seconds();

  const Stopwatch querying;
  result.values.resize(samples.points.rows());
  const auto answer = [&](const tbb::blocked_range<Eigen::Index>& range) {
    Cones cones(casters, directions);
    for (Eigen::Index k = range.begin(); k < range.end(); ++k) {
      check_interruption();
      const Eigen::Index i = order[static_cast<std::size_t>(k)];
      const Eigen::Vector3d inward = -samples.normals.row(i).transpose();
      result.values[i] = inward.isZero(0)
                             ? std::numeric_limits<double>::quiet_NaN()
                             : cones.sdf_at(samples.points.row(i).transpose(), inward, start_triangles.of(i));
    }
  };
  const tbb::blocked_range<Eigen::Index> all(0, samples.points.rows(), 256);
  if (options.parallel) {
    interruptible_parallel_for(all, answer);
  } else {
    answer(all);
  }
  result.query_seconds = querying.seconds();
  return result;
}

}  // namespace shapegauge
