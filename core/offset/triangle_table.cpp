// The loop over triangles, compiled once for each instruction set that Highway knows of.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/triangle_table.cpp"
#include "shapegauge/core/offset/triangle_table.h"

#include <Eigen/Geometry>
#include <cmath>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Sixteen numbers of each of four or eight records, as sixteen vectors: rows of four are loaded, one record for each
/// place of each 128 bits, and transposed there. Faster than to gather them.
template <typename D>
HWY_INLINE void load_transposed(D d, const float* records, const std::int32_t* numbers, hn::Vec<D>* fields) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t i = 0; i < 16; ++i) fields[i] = hn::Set(d, records[16 * static_cast<std::size_t>(numbers[0]) + i]);
#else
  const hn::RepartitionToWide<D> wide;
  for (std::size_t group = 0; group < 4; ++group) {
    const auto row = [&](std::size_t i) {
      const hn::FixedTag<float, 4> quarter;
      const auto at = [&](std::size_t k) {
        return hn::Load(quarter, records + 16 * static_cast<std::size_t>(numbers[k]) + 4 * group);
      };
      if constexpr (hn::MaxLanes(d) == 8) {
        return hn::Combine(d, at(4 + i), at(i));
      } else {
        return at(i);
      }
    };
    const auto r0 = row(0);
    const auto r1 = row(1);
    const auto r2 = row(2);
    const auto r3 = row(3);
    const auto low01 = hn::BitCast(wide, hn::InterleaveLower(d, r0, r1));
    const auto high01 = hn::BitCast(wide, hn::InterleaveUpper(d, r0, r1));
    const auto low23 = hn::BitCast(wide, hn::InterleaveLower(d, r2, r3));
    const auto high23 = hn::BitCast(wide, hn::InterleaveUpper(d, r2, r3));
    fields[4 * group] = hn::BitCast(d, hn::InterleaveLower(wide, low01, low23));
    fields[4 * group + 1] = hn::BitCast(d, hn::InterleaveUpper(wide, low01, low23));
    fields[4 * group + 2] = hn::BitCast(d, hn::InterleaveLower(wide, high01, high23));
    fields[4 * group + 3] = hn::BitCast(d, hn::InterleaveUpper(wide, high01, high23));
  }
#endif
}

/// x - a - v ab - w ac, squared too, for the coordinates v and w of a point of the triangle.
template <typename D>
struct Rest {
  hn::Vec<D> x, y, z, squared;
};

void vectors(const float* records, const std::int32_t* triangles, TriangleTable::Vectors& points) {
  const hn::CappedTag<float, TriangleTable::at_once> d;
  using D = decltype(d);
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, 1.0F);
  for (std::size_t lane = 0; lane < TriangleTable::at_once; lane += hn::Lanes(d)) {
    hn::Vec<D> field[16];
    load_transposed(d, records, triangles + lane, field);
    const auto ax = hn::Sub(hn::Load(d, points.x.data() + lane), field[0]);
    const auto ay = hn::Sub(hn::Load(d, points.y.data() + lane), field[1]);
    const auto az = hn::Sub(hn::Load(d, points.z.data() + lane), field[2]);
    const auto abx = field[3];
    const auto aby = field[4];
    const auto abz = field[5];
    const auto acx = field[6];
    const auto acy = field[7];
    const auto acz = field[8];
    const auto along_ab = hn::MulAdd(ax, abx, hn::MulAdd(ay, aby, hn::Mul(az, abz)));
    const auto along_ac = hn::MulAdd(ax, acx, hn::MulAdd(ay, acy, hn::Mul(az, acz)));
    const auto rest = [&](hn::Vec<D> v, hn::Vec<D> w) {
      Rest<D> at;
      at.x = hn::NegMulAdd(v, abx, hn::NegMulAdd(w, acx, ax));
      at.y = hn::NegMulAdd(v, aby, hn::NegMulAdd(w, acy, ay));
      at.z = hn::NegMulAdd(v, abz, hn::NegMulAdd(w, acz, az));
      at.squared = hn::MulAdd(at.x, at.x, hn::MulAdd(at.y, at.y, hn::Mul(at.z, at.z)));
      return at;
    };
    const auto clamp = [&](hn::Vec<D> t) { return hn::Min(hn::Max(t, zero), one); };
    // Edges of no length are points: nothing is divided by zero.
    const auto dot = [](auto ux, auto uy, auto uz, auto vx, auto vy, auto vz) {
      return hn::MulAdd(ux, vx, hn::MulAdd(uy, vy, hn::Mul(uz, vz)));
    };
    const auto tiny = hn::Set(d, 1e-30F);
    const auto ab2 = dot(abx, aby, abz, abx, aby, abz);
    const auto ac2 = dot(acx, acy, acz, acx, acy, acz);
    const auto abac = dot(abx, aby, abz, acx, acy, acz);
    Rest<D> best = rest(clamp(hn::Div(along_ab, hn::Max(ab2, tiny))), zero);
    const auto keep = [&](const Rest<D>& other, hn::Mask<D> where) {
      best.x = hn::IfThenElse(where, other.x, best.x);
      best.y = hn::IfThenElse(where, other.y, best.y);
      best.z = hn::IfThenElse(where, other.z, best.z);
      best.squared = hn::IfThenElse(where, other.squared, best.squared);
    };
    const Rest<D> on_ac = rest(zero, clamp(hn::Div(along_ac, hn::Max(ac2, tiny))));
    keep(on_ac, hn::Lt(on_ac.squared, best.squared));
    // (x - b) . bc = (x - a) . (ac - ab) - ab . (ac - ab)
    const auto along_bc = hn::Add(hn::Sub(along_ac, along_ab), hn::Sub(ab2, abac));
    const auto t = clamp(hn::Mul(along_bc, field[15]));
    const Rest<D> on_bc = rest(hn::Sub(one, t), t);
    keep(on_bc, hn::Lt(on_bc.squared, best.squared));
    const auto v = dot(ax, ay, az, field[9], field[10], field[11]);
    const auto w = dot(ax, ay, az, field[12], field[13], field[14]);
    const auto inside = hn::And(hn::And(hn::Ge(v, zero), hn::Ge(w, zero)), hn::Le(hn::Add(v, w), one));
    const Rest<D> on_plane = rest(v, w);
    keep(on_plane, hn::And(inside, hn::Lt(on_plane.squared, best.squared)));
    hn::Store(best.x, d, points.x.data() + lane);
    hn::Store(best.y, d, points.y.data() + lane);
    hn::Store(best.z, d, points.z.data() + lane);
    hn::Store(best.squared, d, points.squared.data() + lane);
  }
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(vectors);

void TriangleTable::resize(std::size_t count) { records_.resize(count); }

void TriangleTable::set(std::size_t index, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                        const Eigen::Vector3f& c) {
  const Eigen::Vector3f ab = b - a;
  const Eigen::Vector3f ac = c - a;
  // (x - a) . dual_b and (x - a) . dual_c are the coordinates v and w of x; NaN, and no point is inside, without area.
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
  result.x.fill(static_cast<float>(x.x()));
  result.y.fill(static_cast<float>(x.y()));
  result.z.fill(static_cast<float>(x.z()));
  HWY_DYNAMIC_DISPATCH(vectors)(records_.front().data(), triangles, result);
}

double TriangleTable::squared_distance(const Eigen::Vector3d& x, std::int32_t triangle) const {
  std::array<std::int32_t, at_once> triangles;
  triangles.fill(triangle);
  Vectors vectors;
  vectors_to(x, triangles.data(), vectors);
  return static_cast<double>(vectors.squared[0]);
}

bool TriangleTable::is_over_face(const Eigen::Vector3d& x, std::int32_t triangle, double at_most) const {
  const Record& record = records_[static_cast<std::size_t>(triangle)];
  const auto field = [&](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(record.data() + i); };
  const Eigen::Vector3f from_a = x.cast<float>() - field(0);
  const float v = field(9).dot(from_a);
  const float w = field(12).dot(from_a);
  if (!(v >= 0 && w >= 0 && v + w <= 1)) return false;
  return static_cast<double>((from_a - v * field(3) - w * field(6)).squaredNorm()) <= at_most * at_most;
}

TriangleTable::Place TriangleTable::place_of(const Eigen::Vector3d& point, std::int32_t triangle) const {
  constexpr float inside = 1e-3F;
  const Record& record = records_[static_cast<std::size_t>(triangle)];
  const auto field = [&](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(record.data() + i); };
  const Eigen::Vector3f from_a = point.cast<float>() - field(0);
  const float v = field(9).dot(from_a);
  const float w = field(12).dot(from_a);
  // NaN, without area, is on all three.
  const bool on_ab = !(w > inside);
  const bool on_ac = !(v > inside);
  const bool on_bc = !(1 - v - w > inside);
  const int edges = static_cast<int>(on_ab) + static_cast<int>(on_ac) + static_cast<int>(on_bc);
  if (edges == 0) return {Part::face, Eigen::Vector3d::Zero()};
  if (edges > 1) return {Part::corner, Eigen::Vector3d::Zero()};
  Eigen::Vector3f edge = field(6) - field(3);
  if (on_ab) edge = field(3);
  if (on_ac) edge = field(6);
  return {Part::edge, edge.cast<double>().normalized()};
}

void TriangleTable::vectors_to_each(Vectors& points, const std::int32_t* triangles) const {
  HWY_DYNAMIC_DISPATCH(vectors)(records_.front().data(), triangles, points);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
