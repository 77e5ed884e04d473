// SPDX-License-Identifier: GPL-3.0-or-later
// Rays in the lanes of vectors, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/offset_exit.cpp"
#include "shapegauge/core/offset/offset_exit.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "shapegauge/core/offset/point_search.h"
#include "shapegauge/core/offset/search_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

using Unsigned = hn::Vec<hn::RebindToUnsigned<D>>;

/// Coordinates along one axis of rays through the cubes between the cells' centres.
struct RayAxis {
  Reals origin, direction, inverse;
  Mask is_descending;
  Integers cube;
  std::int32_t cells;   ///< number of cells
  std::int32_t stride;  ///< of block indices

  /// Enters the cube that contains the rays' points.
  HWY_INLINE void enter(Mask where, Reals t) { cube = hn::IfThenElse(integer_mask(where), cube_at(t), cube); }

  [[nodiscard]] HWY_INLINE Integers cube_at(Reals t) const {
    return hn::ConvertTo(DI(), hn::Floor(hn::MulAdd(t, direction, origin)));
  }
  [[nodiscard]] HWY_INLINE hn::Mask<DI> is_in_grid() const {
    return hn::And(hn::Gt(cube, integer(-1)), hn::Lt(cube, integer(cells)));
  }
  [[nodiscard]] HWY_INLINE Integers block() const { return hn::Mul(hn::ShiftRight<2>(cube), integer(stride)); }
  [[nodiscard]] HWY_INLINE Integers cube_in_block() const { return hn::And(cube, integer(block_edge - 1)); }
};

/// Box of cubes that rays leave: one cube, or those of a block.
struct RayBox {
  Integers low, high;  ///< first and last cube along one axis
  Reals end;           ///< parameter at which the rays leave the box along this axis

  HWY_INLINE RayBox(const RayAxis& axis, hn::Mask<DI> is_block)
      : low(hn::IfThenElse(is_block, hn::AndNot(integer(block_edge - 1), axis.cube), axis.cube)),
        high(hn::IfThenElse(is_block, hn::Or(axis.cube, integer(block_edge - 1)), axis.cube)) {
    const Integers side = hn::IfThenElse(integer_mask(axis.is_descending), low, hn::Add(high, integer(1)));
    end = hn::Mul(hn::Sub(hn::ConvertTo(D(), side), axis.origin), axis.inverse);
  }

  /// Returns the cube entered at t.
  [[nodiscard]] HWY_INLINE Integers next(const RayAxis& axis, Reals t) const {
    const Integers beyond =
        hn::IfThenElse(integer_mask(axis.is_descending), hn::Sub(low, integer(1)), hn::Add(high, integer(1)));
    const Integers inside = hn::Min(hn::Max(axis.cube_at(t), low), high);
    return hn::IfThenElse(integer_mask(hn::Le(end, t)), beyond, inside);
  }
};

/// Rays in the lanes of vectors.
class OffsetExitLanes {
 public:
  OffsetExitLanes(const ExteriorGrid& exterior, ClosestTriangles& closest)
      : exterior_(exterior),
        closest_(closest),
        records_(exterior.surface().triangles.records()),
        r_(static_cast<float>(exterior.grid().r)) {
    for (VectorLanes* vectors : {&origin_, &direction_}) store(zero_vectors(), *vectors);
    store(real(0), t_);
  }

  /// Prepares a lane for a ray, from which the first r is known to be covered.
  void begin(std::size_t lane, OffsetExitTask& task) {
    origin_.set(lane, task.origin.cast<float>());
    direction_.set(lane, task.direction.cast<float>());
    t_[lane] = r_;
    task_[lane] = &task;
  }

  /// Advances the running rays. Returns those that have ended.
  LaneBits step(LaneBits running, LaneBits started) {
    entering_ |= started;
    const LaneBits ended = advance(walk(running));
    for_each_lane(ended, [&](std::size_t lane) { task_[lane]->exit = static_cast<double>(t_[lane]); });
    return ended;
  }

 private:
  HWY_INLINE RayAxis axis(const RealLanes& origin, const RealLanes& direction, const IntegerLanes& cube, int k) const {
    constexpr float least = 1e-12F;  // of directions
    const Reals along = load(direction);
    const Mask is_descending = hn::Lt(along, real(0));
    const Reals length = hn::Max(hn::Abs(along), real(least));
    const Eigen::Vector3i& blocks = exterior_.grid().blocks;
    std::int32_t stride = 1;
    for (int i = 0; i < k; ++i) stride *= blocks[i];
    return {.origin = hn::Sub(load(origin), real(0.5F)),
            .direction = along,
            .inverse = hn::Div(hn::IfThenElse(is_descending, real(-1), real(1)), length),
            .is_descending = is_descending,
            .cube = load(cube),
            .cells = block_edge * blocks[k],
            .stride = stride};
  }

  /// Advances rays to the next cube with an exterior corner or out of the grid, until most of them are there. Returns
  /// those.
  LaneBits walk(LaneBits running) {
    constexpr int arrivals_to_stop = std::max(1, 3 * static_cast<int>(hn::MaxLanes(D())) / 4);
    RayAxis x = axis(origin_.x, direction_.x, cube_[0], 0);
    RayAxis y = axis(origin_.y, direction_.y, cube_[1], 1);
    RayAxis z = axis(origin_.z, direction_.z, cube_[2], 2);
    Reals t = load(t_);
    for (RayAxis* along : {&x, &y, &z}) along->enter(mask_of(entering_), t);
    entering_ = 0;
    LaneBits arrived = 0;
    while (true) {
      const hn::Mask<DI> is_in_grid = hn::And(x.is_in_grid(), hn::And(y.is_in_grid(), z.is_in_grid()));
      const Integers block = hn::IfThenElseZero(is_in_grid, hn::Add(hn::Add(x.block(), y.block()), z.block()));
      const Integers state = hn::GatherIndex(DI(), exterior_.blocks(), block);
      arrived |= running & ~bits_of(real_mask(hn::AndNot(has_exterior_corner(x, y, z, state), is_in_grid)));
      if (arrived == running || std::popcount(arrived) >= arrivals_to_stop) break;
      const hn::Mask<DI> is_block = hn::Eq(state, integer(ExteriorGrid::none_exterior));
      const RayBox along_x(x, is_block);
      const RayBox along_y(y, is_block);
      const RayBox along_z(z, is_block);
      const Mask moves = mask_of(running & ~arrived);
      const Reals end = hn::Max(hn::Min(along_x.end, hn::Min(along_y.end, along_z.end)), t);
      t = hn::IfThenElse(moves, end, t);
      x.cube = hn::IfThenElse(integer_mask(moves), along_x.next(x, t), x.cube);
      y.cube = hn::IfThenElse(integer_mask(moves), along_y.next(y, t), y.cube);
      z.cube = hn::IfThenElse(integer_mask(moves), along_z.next(z, t), z.cube);
    }
    store(t, t_);
    store(x.cube, cube_[0]);
    store(y.cube, cube_[1]);
    store(z.cube, cube_[2]);
    return arrived;
  }

  /// Returns the lanes whose cube, in a block of a state, has an exterior corner.
  HWY_INLINE hn::Mask<DI> has_exterior_corner(const RayAxis& x, const RayAxis& y, const RayAxis& z,
                                              Integers state) const {
    const hn::RebindToUnsigned<D> du;
    const Integers cube_z = z.cube_in_block();
    const Integers half = hn::Add(hn::Add(state, state), hn::ShiftRight<1>(cube_z));
    const Unsigned cubes = hn::GatherIndex(du, exterior_.cubes()->data(), half);
    const Integers bit = hn::Add(
        x.cube_in_block(), hn::Add(hn::ShiftLeft<2>(y.cube_in_block()), hn::ShiftLeft<4>(hn::And(cube_z, integer(1)))));
    const Unsigned selected = hn::And(hn::Shr(cubes, hn::BitCast(du, bit)), hn::Set(du, 1));
    return hn::Gt(hn::BitCast(DI(), selected), integer(0));
  }

  /// Advances rays out of the balls of radius r about the closest points of the surrounding triangles. Returns those
  /// that end.
  LaneBits advance(LaneBits arrived) {
    // After a step below this length, in units of r, the surrounding triangles are the same.
    constexpr float negligible = 0.02F;
    const Vectors direction = load(direction_);
    const Vectors x = plus_product(load(origin_), load(t_), direction);
    const auto in_grid = [&](std::size_t k) HWY_ATTR {
      const std::int32_t last = block_edge * exterior_.grid().blocks[static_cast<Eigen::Index>(k)] - 2;
      return hn::Min(hn::Max(load(cube_[k]), integer(0)), integer(last));
    };
    find_cell_triangles(exterior_, {in_grid(0), in_grid(1), in_grid(2)}, cells_.data());
    Reals covered = real(0);
    Reals least = real(infinity);
    Vectors closest = zero_vectors();
    for (TriangleLanes& cell : cells_) {
      measure(records_, x, cell);
      covered = hn::Max(covered, end_of_balls(cell, direction));
      const Reals squared = load(cell.squared);
      closest = select(hn::Lt(squared, least), load(cell.vector), closest);
      least = hn::Min(squared, least);
    }
    const LaneBits has_triangles = arrived & bits_of(hn::Lt(least, real(infinity)));
    move(has_triangles, covered);
    LaneBits going = has_triangles & bits_of(hn::Gt(covered, real(negligible * r_)));
    const LaneBits has_closer = find_closer(has_triangles & ~going, x, difference(x, closest));
    if (has_closer != 0) {
      measure(records_, plus_product(load(origin_), load(t_), direction), closer_);
      covered = end_of_balls(closer_, direction);
      move(has_closer, covered);
      going |= has_closer & bits_of(hn::Gt(covered, real(negligible * r_)));
    }
    entering_ |= going;
    return arrived & ~going;
  }

  HWY_INLINE void move(LaneBits lanes, Reals by) {
    const Reals t = load(t_);
    store(hn::IfThenElse(mask_of(lanes), hn::Add(t, by), t), t_);
  }

  /// Returns the ends of the parts of rays covered by balls of radius r about the triangles' closest points; 0 if the
  /// current point is not covered.
  HWY_INLINE Reals end_of_balls(const TriangleLanes& surrounding, const Vectors& direction) const {
    const float outside = r_ * (1 + 1e-4F);
    const Reals squared = load(surrounding.squared);
    const Mask is_covered = hn::Lt(squared, real(r_ * r_));
    if (hn::AllFalse(D(), is_covered)) return real(0);
    const Reals along = dot(load(surrounding.vector), direction);
    const Reals half_chord2 = hn::MulAdd(along, along, hn::Sub(real(outside * outside), squared));
    return hn::IfThenElseZero(is_covered, hn::Sub(hn::Sqrt(half_chord2), along));
  }

  /// Finds triangles that are nearest to none of the cells but may be closer to x: they are near `nearest`, the
  /// closest point of the surrounding triangles. Returns the lanes with one.
  LaneBits find_closer(LaneBits lanes, const Vectors& x, const Vectors& nearest) {
    VectorLanes positions;
    VectorLanes nearest_points;
    store(x, positions);
    store(nearest, nearest_points);
    store(integer(-1), closer_.triangle);
    LaneBits found = 0;
    for_each_lane(lanes, [&](std::size_t lane) {
      const std::int32_t triangle = closest_.closest_near(nearest_points.at(lane), positions.at(lane));
      for (const TriangleLanes& cell : cells_) {
        if (cell.triangle[lane] == triangle) return;
      }
      if (triangle < 0) return;
      closer_.triangle[lane] = triangle;
      found |= LaneBits{1} << lane;
    });
    return found;
  }

  const ExteriorGrid& exterior_;
  ClosestTriangles& closest_;
  const float* records_;
  float r_;
  std::array<OffsetExitTask*, max_lanes> task_{};
  LaneBits entering_ = 0;  ///< rays whose cube has to be found
  VectorLanes origin_, direction_;
  RealLanes t_;
  std::array<IntegerLanes, 3> cube_{};
  std::array<TriangleLanes, cells_around_point> cells_{};
  TriangleLanes closer_{};
};

void find_exits(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetExitTask> tasks) {
  OffsetExitLanes lanes(exterior, closest);
  run_in_lanes(
      tasks, [&](std::size_t lane, OffsetExitTask& task) { lanes.begin(lane, task); },
      [&](LaneBits running, LaneBits started) { return lanes.step(running, started); });
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(find_exits);

void find_offset_exits(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetExitTask> tasks) {
  if (!tasks.empty()) HWY_DYNAMIC_DISPATCH(find_exits)(exterior, closest, tasks);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
