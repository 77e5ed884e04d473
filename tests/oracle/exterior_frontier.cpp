// The loop over a frontier's cubes, compiled once for each instruction set that Highway knows of.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/oracle/exterior_frontier.cpp"
#include "tests/oracle/exterior_frontier.h"

#include <array>
#include <cmath>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>

#ifndef SHAPEGAUGE_FRONTIER_ARRAYS
#define SHAPEGAUGE_FRONTIER_ARRAYS
namespace shapegauge {
/// The frontier's arrays from the first cube to be looked at on.
struct FrontierArrays {
  std::int32_t count;
  const float *x, *y, *z, *half, *cosine;
  std::array<const float*, 2> normal_x, normal_y, normal_z, bound;
};
inline constexpr std::size_t frontier_lanes = 16;
}  // namespace shapegauge
#endif

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, frontier_lanes>;
using V = hn::Vec<D>;

struct Point {
  V x, y, z;
};

HWY_INLINE V distance_to_cubes(const FrontierArrays& cubes, std::int32_t i, const Point& p) {
  const D d;
  const V half = hn::LoadU(d, cubes.half + i);
  const V x = hn::Max(hn::Sub(hn::AbsDiff(hn::LoadU(d, cubes.x + i), p.x), half), hn::Zero(d));
  const V y = hn::Max(hn::Sub(hn::AbsDiff(hn::LoadU(d, cubes.y + i), p.y), half), hn::Zero(d));
  const V z = hn::Max(hn::Sub(hn::AbsDiff(hn::LoadU(d, cubes.z + i), p.z), half), hn::Zero(d));
  return hn::Sqrt(hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z))));
}

/// How far p is outside of the cubes' half-spaces; negative inside.
template <std::size_t which>
HWY_INLINE V depth(const FrontierArrays& cubes, std::int32_t i, const Point& p) {
  const D d;
  const V along = hn::MulAdd(
      p.x, hn::LoadU(d, cubes.normal_x[which] + i),
      hn::MulAdd(p.y, hn::LoadU(d, cubes.normal_y[which] + i), hn::Mul(p.z, hn::LoadU(d, cubes.normal_z[which] + i))));
  return hn::Sub(hn::LoadU(d, cubes.bound[which] + i), along);
}

/// Distance to the intersection of both half-spaces: to one of the planes, or to the line where they meet if the foot
/// on either plane is outside of the other half-space.
HWY_INLINE V distance_to_half_spaces(const FrontierArrays& cubes, std::int32_t i, const Point& p) {
  const D d;
  const V first = depth<0>(cubes, i, p);
  const V second = depth<1>(cubes, i, p);
  const V cosine = hn::LoadU(d, cubes.cosine + i);
  const V squared_sine = hn::NegMulAdd(cosine, cosine, hn::Set(d, 1.0F));
  const V first_factor = hn::NegMulAdd(cosine, second, first);
  const V second_factor = hn::NegMulAdd(cosine, first, second);
  const V line = hn::Sqrt(hn::Div(hn::MulAdd(first, first_factor, hn::Mul(second, second_factor)), squared_sine));
  const auto meets = hn::And(hn::And(hn::Gt(first_factor, hn::Zero(d)), hn::Gt(second_factor, hn::Zero(d))),
                             hn::Gt(squared_sine, hn::Set(d, 1e-4F)));
  return hn::IfThenElse(meets, line, hn::Max(first, second));
}

/// Writes the numbers and lower bounds of the cubes below the limit; returns how many there are.
std::int32_t find_nearer(const FrontierArrays& cubes, const Eigen::Vector3f& p, float limit, NearbyCube* found) {
  const D d;
  const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
  const Point point = {hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2])};
  const V farthest = hn::Set(d, limit);
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < cubes.count; i += lanes) {
    V lower = distance_to_cubes(cubes, i, point);
    if (hn::AllFalse(d, hn::Lt(lower, farthest))) continue;
    lower = hn::Max(lower, distance_to_half_spaces(cubes, i, point));
    if (hn::AllFalse(d, hn::Lt(lower, farthest))) continue;
    alignas(64) std::array<float, frontier_lanes> bounds;
    hn::Store(lower, d, bounds.data());
    for (std::int32_t k = 0; k < lanes; ++k) {
      if (bounds[static_cast<std::size_t>(k)] < limit) found[count++] = {bounds[static_cast<std::size_t>(k)], i + k};
    }
  }
  return count;
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(find_nearer);

namespace {
constexpr float nowhere = std::numeric_limits<float>::infinity();
}  // namespace

void ExteriorFrontier::restart(const Eigen::Vector3d& origin) {
  origin_ = origin;
  size_ = 0;
  for (auto* array : {&x_, &y_, &z_, &half_, &cosine_}) array->clear();
  for (auto* arrays : {&normal_x_, &normal_y_, &normal_z_, &bound_}) {
    for (auto& array : *arrays) array.clear();
  }
}

void ExteriorFrontier::add(const Eigen::Vector3d& centre, double half) {
  const auto place = static_cast<std::size_t>(size_++);
  if (place % frontier_lanes == 0) {
    // Room for one whole vector from any cube on.
    const std::size_t padded = place + 2 * frontier_lanes;
    x_.resize(padded, nowhere);
    for (auto* array : {&y_, &z_, &half_, &cosine_}) array->resize(padded, 0);
    for (auto* arrays : {&normal_x_, &normal_y_, &normal_z_}) {
      for (auto& array : *arrays) array.resize(padded, 0);
    }
    for (auto& array : bound_) array.resize(padded, std::numeric_limits<float>::lowest());
  }
  const Eigen::Vector3f local = (centre - origin_).cast<float>();
  x_[place] = local[0];
  y_[place] = local[1];
  z_[place] = local[2];
  half_[place] = static_cast<float>(half);
}

void ExteriorFrontier::bound(std::int32_t cube, const HalfSpace& first, const HalfSpace& second) {
  const auto place = static_cast<std::size_t>(cube);
  for (std::size_t i = 0; i < 2; ++i) {
    const HalfSpace& half_space = i == 0 ? first : second;
    normal_x_[i][place] = static_cast<float>(half_space.normal[0]);
    normal_y_[i][place] = static_cast<float>(half_space.normal[1]);
    normal_z_[i][place] = static_cast<float>(half_space.normal[2]);
    bound_[i][place] = static_cast<float>(half_space.bound - half_space.normal.dot(origin_));
  }
  cosine_[place] = static_cast<float>(first.normal.dot(second.normal));
}

void ExteriorFrontier::remove(std::int32_t cube) { x_[static_cast<std::size_t>(cube)] = nowhere; }

void ExteriorFrontier::find_nearer(const Eigen::Vector3d& p, double limit, std::int32_t first,
                                   std::vector<NearbyCube>& found) const {
  const auto start = static_cast<std::size_t>(first);
  const auto from_start = [&](const std::array<std::vector<float>, 2>& arrays) {
    return std::array<const float*, 2>{arrays[0].data() + start, arrays[1].data() + start};
  };
  const std::size_t before = found.size();
  const std::int32_t count = size_ - first;
  found.resize(before + static_cast<std::size_t>(count));
  const FrontierArrays cubes{count,
                             x_.data() + start,
                             y_.data() + start,
                             z_.data() + start,
                             half_.data() + start,
                             cosine_.data() + start,
                             from_start(normal_x_),
                             from_start(normal_y_),
                             from_start(normal_z_),
                             from_start(bound_)};
  NearbyCube* result = found.data() + before;
  const Eigen::Vector3f local = (p - origin_).cast<float>();
  const std::int32_t nearer = HWY_DYNAMIC_DISPATCH(find_nearer)(cubes, local, static_cast<float>(limit), result);
  for (std::int32_t k = 0; k < nearer; ++k) result[k].cube += first;
  found.resize(before + static_cast<std::size_t>(nearer));
}

}  // namespace shapegauge
#endif  // HWY_ONCE
