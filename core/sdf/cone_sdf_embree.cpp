#include "shapegauge/core/sdf/cone_sdf_embree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vector>

#include "shapegauge/core/spatial/ray_caster.h"

namespace shapegauge {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Unit directions of the rays about the axis (0, 0, 1): through the points of a Vogel spiral on the cone's base disk,
/// with radius i/N where sqrt(i/N) would be uniform, so that they are denser near the axis.
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

/// Reorders the values. The mean of the two in the middle where their number is even.
double median(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// Mean of the distances within 1.5 median absolute deviations of their median. Reorders them; `scratch` is as long.
double mean_without_outliers(std::span<double> distances, std::span<double> scratch) {
  constexpr double accepted_deviations = 1.5;
  const double centre = median(distances);
  std::ranges::transform(distances, scratch.begin(), [&](double d) { return std::abs(d - centre); });
  const double limit = accepted_deviations * median(scratch);
  double sum = 0;
  int count = 0;
  for (const double distance : distances) {
    if (std::abs(distance - centre) > limit) continue;
    sum += distance;
    ++count;
  }
  return count > 0 ? sum / count : centre;
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
      begin_.resize(triangles_.size() + 1);
      std::iota(begin_.begin(), begin_.end(), 0);
      group_.resize(triangles_.size());
      std::iota(group_.begin(), group_.end(), 0);
      return;
    }
    group_vertices(shape);
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      for (int k = 0; k < 3; ++k) ++begin_[static_cast<std::size_t>(group_[shape.triangles(f, k)]) + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    triangles_.resize(static_cast<std::size_t>(begin_.back()));
    std::vector<std::int32_t> next = begin_;
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      for (int k = 0; k < 3; ++k) triangles_[next[group_[shape.triangles(f, k)]]++] = static_cast<std::int32_t>(f);
    }
  }

  [[nodiscard]] std::span<const std::int32_t> of(Eigen::Index sample) const {
    const std::int32_t group = group_[sample];
    return std::span(triangles_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
  }

 private:
  /// Vertices of equal coordinates make one group: a seam that doubles them does not end a ray where it starts.
  void group_vertices(const Shape& shape) {
    const auto position = [&](std::int32_t v) {
      return std::array{shape.vertices(v, 0), shape.vertices(v, 1), shape.vertices(v, 2)};
    };
    std::vector<std::int32_t> order(static_cast<std::size_t>(shape.vertices.rows()));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, position);
    group_.resize(order.size());
    std::int32_t groups = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i > 0 && position(order[i]) != position(order[i - 1])) ++groups;
      group_[order[i]] = groups;
    }
    begin_.assign(static_cast<std::size_t>(groups) + 2, 0);
  }

  std::vector<std::int32_t> group_;      // of every sample
  std::vector<std::int32_t> begin_;      // of every group, where its triangles begin
  std::vector<std::int32_t> triangles_;  // of all groups
};

/// Room for the rays of one sample, reused by a thread from sample to sample.
struct Scratch {
  std::vector<double> distances;
  std::vector<double> deviations;
};

double cone_sdf_at(const RayCaster& caster, const Eigen::Vector3d& point, const Eigen::Vector3d& inward,
                   std::span<const Eigen::Vector3d> directions, std::span<const std::int32_t> start, Scratch& scratch) {
  const Eigen::Matrix3d frame = frame_about(inward);
  std::size_t count = 0;
  for (const Eigen::Vector3d& direction : directions) {
    const RayHit hit = caster.first_hit(point, frame * direction, start);
    // A ray that leaves through a face turned inwards says nothing of the inside.
    if (hit && hit.leaving) scratch.distances[count++] = hit.distance;
  }
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  return mean_without_outliers(std::span(scratch.distances).first(count), std::span(scratch.deviations).first(count));
}

}  // namespace

ConeSdfResult cone_sdf_embree(const Shape& shape, const Samples& samples, const ConeSdfOptions& options) {
  ConeSdfResult result;
  const Clock::time_point build_start = Clock::now();
  const RayCaster caster(shape, samples.points.rows() * options.rays);
  const StartTriangles start_triangles(shape, samples);
  const std::vector<Eigen::Vector3d> directions = cone_directions(options);
  result.build_seconds = seconds_since(build_start);

  const Clock::time_point query_start = Clock::now();
  result.values.resize(samples.points.rows());
  const auto answer = [&](const tbb::blocked_range<Eigen::Index>& range) {
    Scratch scratch{std::vector<double>(directions.size()), std::vector<double>(directions.size())};
    for (Eigen::Index i = range.begin(); i < range.end(); ++i) {
      const Eigen::Vector3d inward = -samples.normals.row(i).transpose();
      result.values[i] = inward.isZero(0) ? std::numeric_limits<double>::quiet_NaN()
                                          : cone_sdf_at(caster, samples.points.row(i).transpose(), inward, directions,
                                                        start_triangles.of(i), scratch);
    }
  };
  const tbb::blocked_range<Eigen::Index> all(0, samples.points.rows(), 256);
  if (options.parallel) {
    tbb::parallel_for(all, answer);
  } else {
    answer(all);
  }
  result.query_seconds = seconds_since(query_start);
  return result;
}

}  // namespace shapegauge
