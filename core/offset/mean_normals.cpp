// SPDX-License-Identifier: GPL-3.0-or-later
// Loop over points, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/mean_normals.cpp"
#include "shapegauge/core/offset/mean_normals.h"

#include <Eigen/Geometry>
#include <array>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/offset/point_groups-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

/// Six sums by lane of groups.
using LaneSums = std::array<std::array<float, grid_padding>, 6>;
/// Arrays of three coordinates.
using Coordinates = std::array<const float*, 3>;

/// Sums of area n n^T over points, weighted by proximity.
class NormalSums {
 public:
  HWY_INLINE NormalSums(const GridPoints& points, const Coordinates& normals, const QueryPoint& from, float reach)
      : points_(points), normals_(normals), from_(from), inverse_reach2_(hn::Set(PointLanes(), 1 / (reach * reach))) {
    for (Numbers& sum : sums_) sum = hn::Zero(PointLanes());
  }

  /// Adds a vector of points.
  HWY_INLINE void add(std::size_t i) {
    const PointLanes d;
    const Numbers squared = from_.squared(&points_.x[i], &points_.y[i], &points_.z[i]);
    const Numbers nearness = hn::Max(hn::NegMulAdd(squared, inverse_reach2_, hn::Set(d, 1.0F)), hn::Zero(d));
    const Numbers weight = hn::Mul(hn::Mul(nearness, nearness), hn::LoadU(d, &points_.area[i]));
    const std::array<Numbers, 3> normal{hn::LoadU(d, normals_[0] + i), hn::LoadU(d, normals_[1] + i),
                                        hn::LoadU(d, normals_[2] + i)};
    std::size_t sum = 0;
    for (std::size_t k = 0; k < normal.size(); ++k) {
      const Numbers weighted = hn::Mul(weight, normal[k]);
      for (std::size_t j = k; j < normal.size(); ++j, ++sum) sums_[sum] = hn::MulAdd(weighted, normal[j], sums_[sum]);
    }
  }

  /// Writes the sums of some lanes of groups.
  HWY_INLINE void store(std::size_t lane, LaneSums& sums) const {
    for (std::size_t k = 0; k < sums_.size(); ++k) hn::StoreU(sums_[k], PointLanes(), sums[k].data() + lane);
  }

 private:
  const GridPoints& points_;
  const Coordinates& normals_;
  const QueryPoint& from_;
  Numbers inverse_reach2_;
  std::array<Numbers, 6> sums_;  ///< xx, xy, xz, yy, yz, zz
};

/// Accumulates area n n^T over the groups of the runs within reach. Each of the six entries has sixteen partial sums,
/// whatever the width of vectors.
void add_normals(const GridPoints& points, const Coordinates& normals, const std::vector<GridPoints::Run>& runs,
                 const Eigen::Vector3f& from, float reach, LaneSums& sums) {
  const QueryPoint query(from);
  for (std::size_t lane = 0; lane < PointBoxes::group_size; lane += hn::Lanes(PointLanes())) {
    NormalSums part(points, normals, query, reach);
    for_each_group(runs, query, points.boxes, reach,
                   [&](std::size_t group) HWY_ATTR { part.add(group * PointBoxes::group_size + lane); });
    part.store(lane, sums);
  }
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(add_normals);

MeanNormals::MeanNormals(const BlockGrid& grid, const Shape& shape, const GridSurface& surface, bool parallel)
    : grid_(grid), surface_(surface) {
  if (is_cloud(shape)) return;
  std::vector<Eigen::Vector3f> normals(static_cast<std::size_t>(shape.triangles.rows()));
  for_each_index(parallel, Eigen::Index{0}, shape.triangles.rows(), [&](Eigen::Index f) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return shape.vertices.row(shape.triangles(f, k)); };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    normals[static_cast<std::size_t>(f)] = normal.stableNormalized().cast<float>();
  });
  const std::size_t count = surface.points.size();
  for (AlignedArray<float>* values : {&x_, &y_, &z_}) values->resize(count + grid_padding);
  for_each_index(parallel, std::size_t{0}, count, [&](std::size_t i) {
    const Eigen::Vector3f& normal = normals[static_cast<std::size_t>(surface.points.triangle[i])];
    x_[i] = normal.x();
    y_[i] = normal.y();
    z_[i] = normal.z();
  });
}

Eigen::Vector3d MeanNormals::at(const Eigen::Vector3d& p, const Eigen::Vector3d& n) const {
  constexpr double radius = 0.5;  // in units of r
  if (x_.empty()) return n;
  const double reach = radius * grid_.r;
  std::array<std::array<float, grid_padding>, 6> sums;
  thread_local std::vector<GridPoints::Run> runs;
  surface_.points.find_runs(grid_, p, reach, runs);
  HWY_DYNAMIC_DISPATCH(add_normals)
  (surface_.points, {x_.data(), y_.data(), z_.data()}, runs, p.cast<float>(), static_cast<float>(reach), sums);
  std::array<double, 6> total;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    std::array<float, grid_padding>& lanes = sums[k];
    for (std::size_t half = grid_padding / 2; half > 0; half /= 2) {
      for (std::size_t i = 0; i < half; ++i) lanes[i] += lanes[i + half];
    }
    total[k] = static_cast<double>(lanes[0]);
  }
  const auto& [xx, xy, xz, yy, yz, zz] = total;
  const double weight = xx + yy + zz;  // of normals of length 1
  if (!(weight > 0)) return n;
  Eigen::Matrix3d mean;
  mean << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  mean /= weight;
  return mean * (mean * n);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
