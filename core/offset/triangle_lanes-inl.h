// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors and triangles in the lanes of the processor's vectors, for sources compiled for each instruction set
// supported by Highway.

#if defined(SHAPEGAUGE_CORE_OFFSET_TRIANGLE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHAPEGAUGE_CORE_OFFSET_TRIANGLE_LANES_INL_H
#undef SHAPEGAUGE_CORE_OFFSET_TRIANGLE_LANES_INL_H
#else
#define SHAPEGAUGE_CORE_OFFSET_TRIANGLE_LANES_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>

#include "shapegauge/core/offset/numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {

/// One three-dimensional vector per lane of the SIMD vectors with the Highway tag D.
template <typename D>
using LaneVectors = Vector3<hn::Vec<D>>;

/// Loads one record of sixteen floats per lane, given one index into `records` per lane in `numbers`. Writes sixteen
/// vectors: fields[i] has the i-th float of each lane's record. Loads groups of four floats and transposes them within
/// 128-bit lanes, which is faster than gathering.
template <typename D>
HWY_INLINE void load_transposed(D d, const float* records, const std::int32_t* numbers, hn::Vec<D>* fields) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t i = 0; i < 16; ++i) fields[i] = hn::Set(d, records[16 * static_cast<std::size_t>(numbers[0]) + i]);
#else
  const hn::RepartitionToWide<D> wide;
  for (std::size_t group = 0; group < 4; ++group) {
    const auto row = [&](std::size_t i) HWY_ATTR {
      const hn::FixedTag<float, 4> quarter;
      const auto at = [&](std::size_t k) HWY_ATTR {
        return hn::Load(quarter, records + 16 * static_cast<std::size_t>(numbers[k]) + 4 * group);
      };
      if constexpr (hn::MaxLanes(d) == 16) {
        const hn::Half<D> half;
        return hn::Combine(d, hn::Combine(half, at(12 + i), at(8 + i)), hn::Combine(half, at(4 + i), at(i)));
      } else if constexpr (hn::MaxLanes(d) == 8) {
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

/// Per SIMD lane: vector from the closest point of a triangle to a position, and the squared length of this vector.
template <typename D>
struct LaneDistances {
  LaneVectors<D> vector;  ///< from the closest point of the triangle to the position
  hn::Vec<D> squared;     ///< squared length of `vector`
};

/// Computes, in each lane, the vector from the closest point of a triangle to the `position`. `triangles` has one
/// index into `records` (TriangleTable::records()) per lane.
template <typename D>
HWY_INLINE LaneDistances<D> vectors_from_triangles(D d, const float* records, const std::int32_t* triangles,
                                                   const LaneVectors<D>& position) {
  using Lanes = hn::Vec<D>;
  const Lanes zero = hn::Zero(d);
  const Lanes one = hn::Set(d, 1.0F);
  const Lanes tiny = hn::Set(d, 1e-30F);  // edges of no length are points: nothing is divided by zero
  const auto clamp = [&](Lanes t) HWY_ATTR { return hn::Min(hn::Max(t, zero), one); };
  Lanes field[16];
  load_transposed(d, records, triangles, field);
  const LaneVectors<D> a{hn::Sub(position.x, field[0]), hn::Sub(position.y, field[1]), hn::Sub(position.z, field[2])};
  const LaneVectors<D> ab{field[3], field[4], field[5]};
  const LaneVectors<D> ac{field[6], field[7], field[8]};
  const Lanes along_ab = dot(a, ab);
  const Lanes along_ac = dot(a, ac);
  const Lanes ab2 = dot(ab, ab);
  // x - a - v ab - w ac, for the coordinates v and w of a point of the triangle.
  const auto rest = [&](Lanes v, Lanes w) HWY_ATTR { return minus_product(minus_product(a, w, ac), v, ab); };
  LaneVectors<D> shortest = rest(clamp(hn::Div(along_ab, hn::Max(ab2, tiny))), zero);
  Lanes squared = dot(shortest, shortest);
  const auto consider = [&](const LaneVectors<D>& other, hn::Mask<D> selected) HWY_ATTR {
    const Lanes other2 = dot(other, other);
    const hn::Mask<D> is_shorter = hn::And(selected, hn::Lt(other2, squared));
    shortest = select(is_shorter, other, shortest);
    squared = hn::IfThenElse(is_shorter, other2, squared);
  };
  const hn::Mask<D> all = hn::Eq(zero, zero);
  consider(rest(zero, clamp(hn::Div(along_ac, hn::Max(dot(ac, ac), tiny)))), all);
  // (x - b) . bc = (x - a) . (ac - ab) - ab . (ac - ab)
  const Lanes along_bc = hn::Add(hn::Sub(along_ac, along_ab), hn::Sub(ab2, dot(ab, ac)));
  const Lanes t = clamp(hn::Mul(along_bc, field[15]));
  consider(rest(hn::Sub(one, t), t), all);
  const auto v = dot<Lanes>(a, {field[9], field[10], field[11]});
  const auto w = dot<Lanes>(a, {field[12], field[13], field[14]});
  consider(rest(v, w), hn::And(hn::And(hn::Ge(v, zero), hn::Ge(w, zero)), hn::Le(hn::Add(v, w), one)));
  return {shortest, squared};
}

}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
