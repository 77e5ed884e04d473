// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from positions to points and to the bounding boxes of their groups, for sources compiled for each
// instruction set supported by Highway.

#if defined(SHAPEGAUGE_CORE_OFFSET_POINT_GROUPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHAPEGAUGE_CORE_OFFSET_POINT_GROUPS_INL_H
#undef SHAPEGAUGE_CORE_OFFSET_POINT_GROUPS_INL_H
#else
#define SHAPEGAUGE_CORE_OFFSET_POINT_GROUPS_INL_H
#endif

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Highway tag of vectors with one float per point, or per group of points; at most as wide as a group.
using PointLanes = hn::CappedTag<float, grid_padding>;
using Numbers = hn::Vec<PointLanes>;  ///< SIMD vector of one float per point or group

/// Calls visit(lane) for each lane that is set in a mask.
template <typename Visit>
HWY_INLINE void for_each_lane_of(hn::Mask<PointLanes> mask, const Visit& visit) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(PointLanes(), mask, bytes.data());
  for (std::uint32_t bits = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U; bits != 0; bits &= bits - 1) {
    visit(static_cast<std::size_t>(std::countr_zero(bits)));
  }
}

/// True if the instruction that compresses a vector is faster than copying selected lanes one by one: only AVX-512.
constexpr bool compresses_fast = HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3;

/// Copies those of a SIMD vector's `numbers` whose lanes are set in the mask to the beginning of `copies`, in order.
/// May write a whole vector.
template <typename Number>
HWY_INLINE void copy_selected(const Number* numbers, hn::Mask<PointLanes> mask, Number* copies) {
  if constexpr (compresses_fast) {
    // Compression in registers: compressing stores are slow on some processors.
    const hn::Rebind<Number, PointLanes> d;
    hn::StoreU(hn::Compress(hn::LoadU(d, numbers), hn::RebindMask(d, mask)), d, copies);
  } else {
    for_each_lane_of(mask, [&](std::size_t lane) { *copies++ = numbers[lane]; });
  }
}

/// Copies those points of the vector that begins at point i whose lanes are set in the mask, as copy_selected() does.
/// `points` and `copies` have arrays x, y, z and triangle; copies are written from index `count` on. Returns the index
/// after the last copy.
template <typename Points, typename Copies>
HWY_INLINE std::size_t copy_selected_points(const Points& points, std::size_t i, hn::Mask<PointLanes> mask,
                                            Copies& copies, std::size_t count) {
  if constexpr (compresses_fast) {
    copy_selected(&points.x[i], mask, &copies.x[count]);
    copy_selected(&points.y[i], mask, &copies.y[count]);
    copy_selected(&points.z[i], mask, &copies.z[count]);
    copy_selected(&points.triangle[i], mask, &copies.triangle[count]);
    return count + hn::CountTrue(PointLanes(), mask);
  } else {
    for_each_lane_of(mask, [&](std::size_t lane) {
      copies.x[count] = points.x[i + lane];
      copies.y[count] = points.y[i + lane];
      copies.z[count] = points.z[i + lane];
      copies.triangle[count++] = points.triangle[i + lane];
    });
    return count;
  }
}

/// Query position from which distances are computed, repeated in all lanes.
struct QueryPoint {
  HWY_INLINE explicit QueryPoint(const Eigen::Vector3f& at)
      : x(hn::Set(PointLanes(), at.x())), y(hn::Set(PointLanes(), at.y())), z(hn::Set(PointLanes(), at.z())) {}

  /// Returns the squared distances from the query position to a vector of points.
  [[nodiscard]] HWY_INLINE Numbers squared(const float* px, const float* py, const float* pz) const {
    const PointLanes d;
    return squared_length(hn::Sub(hn::LoadU(d, px), x), hn::Sub(hn::LoadU(d, py), y), hn::Sub(hn::LoadU(d, pz), z));
  }

  /// Returns the Chebyshev distances (largest differences of coordinates) from the query position to a vector of
  /// points.
  [[nodiscard]] HWY_INLINE Numbers largest_difference(Numbers px, Numbers py, Numbers pz) const {
    return hn::Max(hn::Max(hn::Abs(hn::Sub(px, x)), hn::Abs(hn::Sub(py, y))), hn::Abs(hn::Sub(pz, z)));
  }

  /// Distances from the query position to a vector of boxes, along each axis; 0 inside.
  struct ToBoxes {
    Numbers x, y, z;

    [[nodiscard]] HWY_INLINE Numbers squared() const { return squared_length(x, y, z); }    ///< Euclidean, squared
    [[nodiscard]] HWY_INLINE Numbers largest() const { return hn::Max(hn::Max(x, y), z); }  ///< Chebyshev
  };
  /// Returns the distances to the bounding boxes of consecutive groups of points, beginning with the group `first`.
  [[nodiscard]] HWY_INLINE ToBoxes to_boxes(const PointBoxes& boxes, std::size_t first) const {
    return {to_interval(x, &boxes.low[0][first], &boxes.high[0][first]),
            to_interval(y, &boxes.low[1][first], &boxes.high[1][first]),
            to_interval(z, &boxes.low[2][first], &boxes.high[2][first])};
  }

  Numbers x, y, z;  ///< coordinates of the query position

 private:
  HWY_INLINE static Numbers squared_length(Numbers dx, Numbers dy, Numbers dz) {
    return hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
  }
  HWY_INLINE static Numbers to_interval(Numbers from, const float* low, const float* high) {
    const PointLanes d;
    const Numbers beyond = hn::Max(hn::Sub(hn::LoadU(d, low), from), hn::Sub(from, hn::LoadU(d, high)));
    return hn::Max(beyond, hn::Zero(d));
  }
};

/// Calls visit(first group, mask) for SIMD vectors of consecutive groups of points. The mask is set in the lanes of
/// groups with points of the runs, each of which is visited once. The runs must be ascending and not empty.
template <typename Visit>
HWY_INLINE void for_each_vector_of_groups(const std::vector<GridPoints::Run>& runs, const Visit& visit) {
  const PointLanes d;
  std::size_t next = 0;
  for (const auto& [begin, end] : runs) {
    std::size_t group = std::max<std::size_t>(next, begin / PointBoxes::group_size);
    next = (end - 1) / PointBoxes::group_size + 1;
    for (; group < next; group += hn::Lanes(d)) visit(group, hn::FirstN(d, next - group));
  }
}

/// Calls visit(group) for each group with points of the runs whose bounding box is within `distance` of the query
/// position.
template <typename Visit>
HWY_INLINE void for_each_group(const std::vector<GridPoints::Run>& runs, const QueryPoint& from,
                               const PointBoxes& boxes, float distance, const Visit& visit) {
  const Numbers limit = hn::Set(PointLanes(), distance * distance);
  for_each_vector_of_groups(runs, [&](std::size_t first, hn::Mask<PointLanes> is_group) HWY_ATTR {
    const auto is_near = hn::And(is_group, hn::Le(from.to_boxes(boxes, first).squared(), limit));
    for_each_lane_of(is_near, [&](std::size_t group) HWY_ATTR { visit(first + group); });
  });
}

}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
