// Loop over points, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/mean_normals.cpp"
#include "shapegauge/core/offset/mean_normals.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Arrays of three coordinates.
using Coordinates = std::array<const float*, 3>;

/// Accumulates area n n^T over the points of the runs, weighted by proximity. Each of the six entries has sixteen
/// partial sums, whatever the vector width: the same bits on every machine.
void add_normals(const Coordinates& points, const Coordinates& normals, const float* area,
                 const std::vector<GridPoints::Run>& runs, const Eigen::Vector3f& from, float inverse_reach2,
                 std::array<std::array<float, grid_padding>, 6>& sums) {
  const hn::CappedTag<float, grid_padding> d;
  const auto one = hn::Set(d, 1.0F);
  const auto zero = hn::Zero(d);
  for (std::size_t lane = 0; lane < grid_padding; lane += hn::Lanes(d)) {
    auto xx = zero;
    auto xy = zero;
    auto xz = zero;
    auto yy = zero;
    auto yz = zero;
    auto zz = zero;
    for (const auto& [begin, end] : runs) {
      for (std::size_t i = begin + lane; i < end; i += grid_padding) {
        const auto dx = hn::Sub(hn::LoadU(d, points[0] + i), hn::Set(d, from.x()));
        const auto dy = hn::Sub(hn::LoadU(d, points[1] + i), hn::Set(d, from.y()));
        const auto dz = hn::Sub(hn::LoadU(d, points[2] + i), hn::Set(d, from.z()));
        const auto squared = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
        auto nearness = hn::Max(hn::NegMulAdd(squared, hn::Set(d, inverse_reach2), one), zero);
        nearness = hn::IfThenElse(hn::FirstN(d, end - i), nearness, zero);
        const auto weight = hn::Mul(hn::Mul(nearness, nearness), hn::LoadU(d, area + i));
        const auto x = hn::LoadU(d, normals[0] + i);
        const auto y = hn::LoadU(d, normals[1] + i);
        const auto z = hn::LoadU(d, normals[2] + i);
        const auto weighted_x = hn::Mul(weight, x);
        const auto weighted_y = hn::Mul(weight, y);
        xx = hn::MulAdd(weighted_x, x, xx);
        xy = hn::MulAdd(weighted_x, y, xy);
        xz = hn::MulAdd(weighted_x, z, xz);
        yy = hn::MulAdd(weighted_y, y, yy);
        yz = hn::MulAdd(weighted_y, z, yz);
        zz = hn::MulAdd(hn::Mul(weight, z), z, zz);
      }
    }
    hn::StoreU(xx, d, sums[0].data() + lane);
    hn::StoreU(xy, d, sums[1].data() + lane);
    hn::StoreU(xz, d, sums[2].data() + lane);
    hn::StoreU(yy, d, sums[3].data() + lane);
    hn::StoreU(yz, d, sums[4].data() + lane);
    hn::StoreU(zz, d, sums[5].data() + lane);
  }
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(add_normals);

MeanNormals::MeanNormals(const BlockGrid& grid, const Shape& shape, const GridSurface& surface)
    : grid_(grid), surface_(surface) {
  if (is_cloud(shape)) return;
  std::vector<Eigen::Vector3f> normals(static_cast<std::size_t>(shape.triangles.rows()));
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return shape.vertices.row(shape.triangles(f, k)); };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    normals[static_cast<std::size_t>(f)] = normal.stableNormalized().cast<float>();
  }
  const std::size_t count = surface.points.triangle.size();
  for (std::vector<float>* values : {&x_, &y_, &z_}) values->resize(count + grid_padding);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f& normal = normals[static_cast<std::size_t>(surface.points.triangle[i])];
    x_[i] = normal.x();
    y_[i] = normal.y();
    z_[i] = normal.z();
  }
}

Eigen::Vector3d MeanNormals::at(const Eigen::Vector3d& p, const Eigen::Vector3d& n) const {
  constexpr double radius = 0.5;  // in units of r
  if (x_.empty()) return n;
  const double reach = radius * grid_.r;
  std::array<std::array<float, grid_padding>, 6> sums;
  const GridPoints& points = surface_.points;
  thread_local std::vector<GridPoints::Run> runs;
  points.find_runs(grid_, p, reach, runs);
  HWY_DYNAMIC_DISPATCH(add_normals)
  ({points.x.data(), points.y.data(), points.z.data()}, {x_.data(), y_.data(), z_.data()}, points.area.data(), runs,
   p.cast<float>(), static_cast<float>(1 / (reach * reach)), sums);
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
