// The loop over points, compiled once for each instruction set that Highway knows of.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/mean_normals.cpp"
#include "shapegauge/core/offset/mean_normals.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Adds weight (n_j . n) n_j and weight of the runs' points to sixteen sums of each: as many whatever the
/// processor, so that all round alike.
void add_normals(const std::array<const float*, 3>& points, const std::array<const float*, 3>& normals,
                 const float* area, const std::vector<GridPoints::Run>& runs, const Eigen::Vector3f& from,
                 const Eigen::Vector3f& along, float inverse_reach2, std::array<float, 4 * grid_padding>& sums) {
  const hn::CappedTag<float, grid_padding> d;
  const auto one = hn::Set(d, 1.0F);
  const auto zero = hn::Zero(d);
  for (std::size_t lane = 0; lane < grid_padding; lane += hn::Lanes(d)) {
    auto sum_x = hn::LoadU(d, sums.data() + lane);
    auto sum_y = hn::LoadU(d, sums.data() + grid_padding + lane);
    auto sum_z = hn::LoadU(d, sums.data() + 2 * grid_padding + lane);
    auto weights = hn::LoadU(d, sums.data() + 3 * grid_padding + lane);
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
        const auto cosine = hn::MulAdd(x, hn::Set(d, along.x()),
                                       hn::MulAdd(y, hn::Set(d, along.y()), hn::Mul(z, hn::Set(d, along.z()))));
        const auto weighted = hn::Mul(weight, cosine);
        sum_x = hn::MulAdd(weighted, x, sum_x);
        sum_y = hn::MulAdd(weighted, y, sum_y);
        sum_z = hn::MulAdd(weighted, z, sum_z);
        weights = hn::Add(weights, weight);
      }
    }
    hn::StoreU(sum_x, d, sums.data() + lane);
    hn::StoreU(sum_y, d, sums.data() + grid_padding + lane);
    hn::StoreU(sum_z, d, sums.data() + 2 * grid_padding + lane);
    hn::StoreU(weights, d, sums.data() + 3 * grid_padding + lane);
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
  constexpr double radius = 0.5;  // in parts of r
  if (x_.empty()) return n;
  const double reach = radius * grid_.r;
  std::array<float, 4 * grid_padding> sums{};
  thread_local std::vector<GridPoints::Run> runs;
  surface_.points.find_runs(grid_, p, reach, runs);
  HWY_DYNAMIC_DISPATCH(add_normals)
  ({surface_.points.x.data(), surface_.points.y.data(), surface_.points.z.data()}, {x_.data(), y_.data(), z_.data()},
   surface_.points.area.data(), runs, p.cast<float>(), n.cast<float>(), static_cast<float>(1 / (reach * reach)), sums);
  const auto total = [&](std::size_t which) {
    const auto from = sums.begin() + static_cast<std::ptrdiff_t>(which * grid_padding);
    return static_cast<double>(std::accumulate(from, from + grid_padding, 0.0F));
  };
  const double weights = total(3);
  return weights > 0 ? Eigen::Vector3d(total(0) / weights, total(1) / weights, total(2) / weights) : n;
}

}  // namespace shapegauge
#endif  // HWY_ONCE
