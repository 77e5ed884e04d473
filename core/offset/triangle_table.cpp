// SPDX-License-Identifier: GPL-3.0-or-later
// Loop over triangles, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/triangle_table.cpp"
#include "shapegauge/core/offset/triangle_table.h"

#include <Eigen/Geometry>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>

#include "shapegauge/core/offset/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

/// Computes the vectors from the closest points of triangles to query points. points_at(d, lane) returns a vector of
/// query points.
template <typename PointsAt>
HWY_INLINE void vectors_to_points(const float* records, const std::int32_t* triangles, const PointsAt& points_at,
                                  TriangleTable::Vectors& vectors) {
  const hn::CappedTag<float, TriangleTable::batch_size> d;
  for (std::size_t lane = 0; lane < TriangleTable::batch_size; lane += hn::Lanes(d)) {
    const auto [vector, squared] = vectors_from_triangles(d, records, triangles + lane, points_at(d, lane));
    hn::Store(vector.x, d, vectors.x.data() + lane);
    hn::Store(vector.y, d, vectors.y.data() + lane);
    hn::Store(vector.z, d, vectors.z.data() + lane);
    hn::Store(squared, d, vectors.squared.data() + lane);
  }
}

void vectors_to_one(const float* records, const std::int32_t* triangles, const Eigen::Vector3f& x,
                    TriangleTable::Vectors& vectors) {
  const auto same_for_all = [&](auto d, std::size_t /*lane*/) HWY_ATTR {
    return LaneVectors<decltype(d)>{hn::Set(d, x.x()), hn::Set(d, x.y()), hn::Set(d, x.z())};
  };
  vectors_to_points(records, triangles, same_for_all, vectors);
}

/// Replaces the points.
void vectors_to_each_of(const float* records, const std::int32_t* triangles, TriangleTable::Vectors& points) {
  const auto at = [&](auto d, std::size_t lane) HWY_ATTR {
    return LaneVectors<decltype(d)>{hn::Load(d, points.x.data() + lane), hn::Load(d, points.y.data() + lane),
                                    hn::Load(d, points.z.data() + lane)};
  };
  vectors_to_points(records, triangles, at, points);
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(vectors_to_one);
HWY_EXPORT(vectors_to_each_of);

void TriangleTable::resize(std::size_t count) { records_.resize(count); }

void TriangleTable::set(std::size_t index, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                        const Eigen::Vector3f& c) {
  const Eigen::Vector3f ab = b - a;
  const Eigen::Vector3f ac = c - a;
  // (x - a) . dual_b and (x - a) . dual_c are the coordinates v and w of x. They are NaN for a degenerate triangle,
  // which therefore contains no point.
  const Eigen::Vector3d normal = ab.cast<double>().cross(ac.cast<double>());
  const double normal2 = normal.squaredNorm();
  Eigen::Vector3f dual_b = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  Eigen::Vector3f dual_c = dual_b;
  if (normal2 > 0) {
    dual_b = (ac.cast<double>().cross(normal) / normal2).cast<float>();
    dual_c = (normal.cross(ab.cast<double>()) / normal2).cast<float>();
  }
  const float bc2 = (c - b).squaredNorm();
  const float inverse_bc2 = bc2 > 1e-30F ? 1 / bc2 : 0;
  records_[index] = {{a.x(), a.y(), a.z(), ab.x(), ab.y(), ab.z(), ac.x(), ac.y(), ac.z(), dual_b.x(), dual_b.y(),
                      dual_b.z(), dual_c.x(), dual_c.y(), dual_c.z(), inverse_bc2}};
}

void TriangleTable::vectors_to(const Eigen::Vector3d& x, const std::int32_t* triangles, Vectors& result) const {
  HWY_DYNAMIC_DISPATCH(vectors_to_one)(records_.front().data(), triangles, x.cast<float>(), result);
}

double TriangleTable::squared_distance(const Eigen::Vector3d& x, std::int32_t triangle) const {
  std::array<std::int32_t, batch_size> triangles;
  triangles.fill(triangle);
  Vectors vectors;
  vectors_to(x, triangles.data(), vectors);
  return static_cast<double>(vectors.squared[0]);
}

bool TriangleTable::is_over_face(const Eigen::Vector3d& x, std::int32_t triangle, double max_plane_distance) const {
  const Record& record = records_[static_cast<std::size_t>(triangle)];
  const auto field = [&](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(record.data() + i); };
  const Eigen::Vector3f from_a = x.cast<float>() - field(0);
  const float v = field(9).dot(from_a);
  const float w = field(12).dot(from_a);
  if (!(v >= 0 && w >= 0 && v + w <= 1)) return false;
  return static_cast<double>((from_a - v * field(3) - w * field(6)).squaredNorm()) <=
         max_plane_distance * max_plane_distance;
}

void TriangleTable::vectors_to_each(Vectors& points, const std::int32_t* triangles) const {
  HWY_DYNAMIC_DISPATCH(vectors_to_each_of)(records_.front().data(), triangles, points);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
