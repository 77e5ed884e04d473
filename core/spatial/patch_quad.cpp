// Arithmetic on the points of four patches at once, compiled once for each instruction set that Highway knows of.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/spatial/patch_quad.cpp"
#include "shapegauge/core/spatial/patch_quad.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, PatchQuad::lanes>;
using V = hn::Vec<D>;

/// A vector for every lane.
struct Vectors {
  V x, y, z;
};

HWY_INLINE V dot(const Vectors& a, const Eigen::Vector3f& b) {
  const D d;
  return hn::MulAdd(a.x, hn::Set(d, b[0]), hn::MulAdd(a.y, hn::Set(d, b[1]), hn::Mul(a.z, hn::Set(d, b[2]))));
}

HWY_INLINE Vectors minus(const Vectors& a, const Eigen::Vector3f& b) {
  const D d;
  return {hn::Sub(a.x, hn::Set(d, b[0])), hn::Sub(a.y, hn::Set(d, b[1])), hn::Sub(a.z, hn::Set(d, b[2]))};
}

HWY_INLINE V to_edge(const Vectors& v, const Eigen::Vector3f& edge, float inverse) {
  const D d;
  const V t = hn::Min(hn::Max(hn::Mul(dot(v, edge), hn::Set(d, inverse)), hn::Zero(d)), hn::Set(d, 1.0F));
  const V x = hn::NegMulAdd(t, hn::Set(d, edge[0]), v.x);
  const V y = hn::NegMulAdd(t, hn::Set(d, edge[1]), v.y);
  const V z = hn::NegMulAdd(t, hn::Set(d, edge[2]), v.z);
  return hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
}

float inverse_or_zero(double length2) {
  const auto inverse = static_cast<float>(1 / length2);
  return std::isfinite(inverse) ? inverse : 0;
}

void distances(const PatchQuad& quad, const Triangle& triangle, float* HWY_RESTRICT result) {
  const Eigen::Vector3d ab = triangle.b - triangle.a;
  const Eigen::Vector3d ac = triangle.c - triangle.a;
  const Eigen::Vector3d cross = ab.cross(ac);
  const double cross2 = cross.squaredNorm();
  // Without an area no point projects into the triangle: a coordinate that is not a number fails every comparison.
  const double inverse = cross2 > 0 ? 1 / cross2 : std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3f normal = (cross * std::sqrt(inverse)).cast<float>();
  const Eigen::Vector3f dual_b = (ac.cross(cross) * inverse).cast<float>();
  const Eigen::Vector3f dual_c = (cross.cross(ab) * inverse).cast<float>();
  const Eigen::Vector3f a = triangle.a.cast<float>();
  const Eigen::Vector3f edge_ab = ab.cast<float>();
  const Eigen::Vector3f edge_ac = ac.cast<float>();
  const Eigen::Vector3f edge_bc = (ac - ab).cast<float>();
  const float inverse_ab = inverse_or_zero(ab.squaredNorm());
  const float inverse_ac = inverse_or_zero(ac.squaredNorm());
  const float inverse_bc = inverse_or_zero((ac - ab).squaredNorm());
  const D d;
  for (std::size_t lane = 0; lane < PatchQuad::lanes; lane += hn::Lanes(d)) {
    const Vectors point = {hn::Load(d, quad.x.data() + lane), hn::Load(d, quad.y.data() + lane),
                           hn::Load(d, quad.z.data() + lane)};
    const Vectors from_a = minus(point, a);
    const Vectors from_b = minus(from_a, edge_ab);
    V nearest = hn::Min(to_edge(from_a, edge_ab, inverse_ab), to_edge(from_a, edge_ac, inverse_ac));
    nearest = hn::Min(nearest, to_edge(from_b, edge_bc, inverse_bc));
    const V height = dot(from_a, normal);
    const V b = dot(from_a, dual_b);
    const V c = dot(from_a, dual_c);
    const V zero = hn::Zero(d);
    const auto inside = hn::And(hn::And(hn::Ge(b, zero), hn::Ge(c, zero)), hn::Le(hn::Add(b, c), hn::Set(d, 1.0F)));
    hn::Store(hn::IfThenElse(inside, hn::Mul(height, height), nearest), d, result + lane);
  }
}

/// Places of the quad's points in the square, from -1 to 1: nine corners, four middles, padding.
alignas(64) constexpr std::array<float, PatchQuad::lanes> place_u = {-1, 0,   1,  -1,  0,  1,  -1, 0,
                                                                     1,  -.5, .5, -.5, .5, .5, .5, .5};
alignas(64) constexpr std::array<float, PatchQuad::lanes> place_v = {-1, -1,  -1,  0,  0,  0,  1,  1,
                                                                     1,  -.5, -.5, .5, .5, .5, .5, .5};

void points(float radius, float u, float v, float half, float* HWY_RESTRICT along_axis, float* HWY_RESTRICT along_u,
            float* HWY_RESTRICT along_v) {
  const D d;
  for (std::size_t lane = 0; lane < PatchQuad::lanes; lane += hn::Lanes(d)) {
    const V pu = hn::MulAdd(hn::Load(d, place_u.data() + lane), hn::Set(d, half), hn::Set(d, u));
    const V pv = hn::MulAdd(hn::Load(d, place_v.data() + lane), hn::Set(d, half), hn::Set(d, v));
    const V length = hn::Sqrt(hn::MulAdd(pu, pu, hn::MulAdd(pv, pv, hn::Set(d, 1.0F))));
    const V scale = hn::Div(hn::Set(d, radius), length);
    hn::Store(scale, d, along_axis + lane);
    hn::Store(hn::Mul(pu, scale), d, along_u + lane);
    hn::Store(hn::Mul(pv, scale), d, along_v + lane);
  }
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(distances);
HWY_EXPORT(points);

PatchQuad patch_quad(double radius, int face, double u, double v, double half) {
  PatchQuad quad;
  const std::array<float*, 3> coordinates = {quad.x.data(), quad.y.data(), quad.z.data()};
  const auto axis = static_cast<std::size_t>(face % 3);
  float* along_axis = coordinates[axis];
  HWY_DYNAMIC_DISPATCH(points)
  (static_cast<float>(radius), static_cast<float>(u), static_cast<float>(v), static_cast<float>(half), along_axis,
   coordinates[(axis + 1) % 3], coordinates[(axis + 2) % 3]);
  if (face >= 3) std::for_each_n(along_axis, PatchQuad::lanes, [](float& value) { value = -value; });
  return quad;
}

std::array<float, PatchQuad::lanes> squared_distances(const PatchQuad& quad, const Triangle& triangle) {
  alignas(64) std::array<float, PatchQuad::lanes> result;
  HWY_DYNAMIC_DISPATCH(distances)(quad, triangle, result.data());
  return result;
}

}  // namespace shapegauge
#endif  // HWY_ONCE
