// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, vectors and masks of searches, one search per lane of the processor's vectors, for sources compiled for each
// instruction set supported by Highway.

#if defined(SHAPEGAUGE_CORE_OFFSET_SEARCH_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHAPEGAUGE_CORE_OFFSET_SEARCH_LANES_INL_H
#undef SHAPEGAUGE_CORE_OFFSET_SEARCH_LANES_INL_H
#else
#define SHAPEGAUGE_CORE_OFFSET_SEARCH_LANES_INL_H
#endif

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>
#include <limits>
#include <span>

#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/offset/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {

using D = hn::CappedTag<float, 16>;  ///< Highway tag of one float per lane
using DI = hn::RebindToSigned<D>;    ///< Highway tag of one 32-bit integer per lane
using Reals = hn::Vec<D>;            ///< SIMD vector of one float per lane
using Integers = hn::Vec<DI>;        ///< SIMD vector of one 32-bit integer per lane
using Mask = hn::Mask<D>;            ///< one truth value per lane of a SIMD vector
using Vectors = LaneVectors<D>;      ///< one three-dimensional vector per lane
using LaneBits = std::uint32_t;      ///< set of lanes of a SIMD vector: bit i for lane i

constexpr std::size_t max_lanes = 16;                               ///< maximum number of lanes of a SIMD vector
constexpr float infinity = std::numeric_limits<float>::infinity();  ///< distance where there is no triangle

/// Array in memory of one float per SIMD lane.
struct alignas(64) RealLanes : std::array<float, max_lanes> {};
/// Array in memory of one integer per SIMD lane.
struct alignas(64) IntegerLanes : std::array<std::int32_t, max_lanes> {};
/// Arrays in memory of one three-dimensional vector per SIMD lane.
struct VectorLanes {
  RealLanes x, y, z;

  void set(std::size_t lane, const Eigen::Vector3f& to) {
    x[lane] = to.x();
    y[lane] = to.y();
    z[lane] = to.z();
  }
  [[nodiscard]] Eigen::Vector3d at(std::size_t lane) const {
    return {static_cast<double>(x[lane]), static_cast<double>(y[lane]), static_cast<double>(z[lane])};
  }
};

HWY_INLINE Reals load(const RealLanes& lanes) { return hn::Load(D(), lanes.data()); }
HWY_INLINE Integers load(const IntegerLanes& lanes) { return hn::Load(DI(), lanes.data()); }
HWY_INLINE Vectors load(const VectorLanes& lanes) { return {load(lanes.x), load(lanes.y), load(lanes.z)}; }
HWY_INLINE void store(Reals from, RealLanes& lanes) { hn::Store(from, D(), lanes.data()); }
HWY_INLINE void store(Integers from, IntegerLanes& lanes) { hn::Store(from, DI(), lanes.data()); }
HWY_INLINE void store(const Vectors& from, VectorLanes& lanes) {
  store(from.x, lanes.x);
  store(from.y, lanes.y);
  store(from.z, lanes.z);
}

HWY_INLINE Reals real(float value) { return hn::Set(D(), value); }                ///< vector with `value` in all lanes
HWY_INLINE Integers integer(std::int32_t value) { return hn::Set(DI(), value); }  ///< vector with `value` in all lanes
HWY_INLINE Vectors zero_vectors() { return zero_vector<Reals>(); }                ///< zero vector in all lanes
HWY_INLINE Mask empty_mask() { return hn::Lt(real(0), real(0)); }                 ///< mask that is false in all lanes
/// Converts a mask of integers to a mask of floats.
HWY_INLINE Mask real_mask(hn::Mask<DI> mask) { return hn::RebindMask(D(), mask); }
/// Converts a mask of floats to a mask of integers.
HWY_INLINE hn::Mask<DI> integer_mask(Mask mask) { return hn::RebindMask(DI(), mask); }
/// Returns the mask of the lanes whose `number` is the index of a triangle, not -1 for none.
HWY_INLINE Mask is_triangle(Integers number) { return real_mask(hn::Gt(number, integer(-1))); }

constexpr LaneBits all_lanes() { return (LaneBits{1} << hn::MaxLanes(D())) - 1; }
HWY_INLINE LaneBits bits_of(Mask mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(D(), mask, bytes.data());
  return (bytes[0] | static_cast<LaneBits>(bytes[1]) << 8U) & all_lanes();
}
HWY_INLINE Mask mask_of(LaneBits bits) {
  const std::array<std::uint8_t, 8> bytes{static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U)};
  return hn::LoadMaskBits(D(), bytes.data());
}
/// Calls visit(lane) for each lane whose bit is set in `bits`.
template <typename Visit>
void for_each_lane(LaneBits bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Runs tasks in the lanes of SIMD vectors; a lane whose task ends takes the next task. `begin(lane, task)` prepares a
/// lane. `step(running, started)` advances the running lanes, some of which have just started, and returns those whose
/// tasks have ended.
template <typename Task, typename Begin, typename Step>
void run_in_lanes(std::span<Task> tasks, const Begin& begin, const Step& step) {
  std::size_t next = 0;
  LaneBits running = 0;
  while (true) {
    LaneBits started = 0;
    for (LaneBits idle = all_lanes() & ~running; idle != 0 && next < tasks.size(); idle &= idle - 1) {
      begin(static_cast<std::size_t>(std::countr_zero(idle)), tasks[next++]);
      started |= idle & -idle;
    }
    running |= started;
    if (running == 0) return;
    running &= ~step(running, started);
  }
}

/// One triangle per SIMD lane, with the vector from the triangle's closest point to the position in this lane.
struct TriangleLanes {
  IntegerLanes triangle;  ///< index of the triangle (TriangleTable); -1 if there is none
  VectorLanes vector;     ///< vector from the closest point of the triangle to the position
  RealLanes squared;      ///< squared length of `vector`; infinite without a triangle
};

/// Sets `vector` and `squared` of `surrounding` for the `positions`, given its triangles. `records` are
/// TriangleTable::records().
HWY_INLINE void measure(const float* records, const Vectors& positions, TriangleLanes& surrounding) {
  const Integers triangle = load(surrounding.triangle);
  const Mask has_triangle = is_triangle(triangle);
  if (hn::AllFalse(D(), has_triangle)) return store(real(infinity), surrounding.squared);
  IntegerLanes numbers;
  store(hn::Max(triangle, integer(0)), numbers);
  const auto [vector, squared] = vectors_from_triangles(D(), records, numbers.data(), positions);
  store(vector, surrounding.vector);
  store(hn::IfThenElse(has_triangle, squared, real(infinity)), surrounding.squared);
}

constexpr std::size_t cells_around_point = 8;  ///< number of cells around a position (CellsAround)

/// Coordinates of one cell of the grid per SIMD lane.
struct CellLanes {
  Integers x, y, z;
};

/// Returns, per lane, the cell with the lowest coordinates among the eight that cells_around() returns for a position.
HWY_INLINE CellLanes lowest_cells_around(const ExteriorGrid& exterior, const Vectors& positions) {
  const auto along = [&](Reals coordinate, int axis) HWY_ATTR {
    const Integers nearest_corner = hn::ConvertTo(DI(), hn::Add(coordinate, real(0.5F)));
    const std::int32_t last = block_edge * exterior.grid().blocks[axis] - 2;
    return hn::Min(hn::Max(hn::Sub(nearest_corner, integer(1)), integer(0)), integer(last));
  };
  return {along(positions.x, 0), along(positions.y, 1), along(positions.z, 2)};
}

/// Finds, in each lane, the triangles closest to the eight cells around a position, given the cell with the lowest
/// coordinates. Sets the triangles of the eight entries of `found`. Returns the lanes with an exterior cell.
HWY_INLINE Mask find_cell_triangles(const ExteriorGrid& exterior, const CellLanes& lowest, TriangleLanes* found) {
  const DI di;
  constexpr std::int32_t block_size = sizeof(BoundaryBlock) / sizeof(std::int32_t);
  const std::int32_t* nearest = exterior.boundary().front().nearest.data();
  const std::array<Integers, 3> low{lowest.x, lowest.y, lowest.z};
  std::array<std::array<Integers, 2>, 3> blocks;
  std::array<std::array<Integers, 2>, 3> bits;
  std::int32_t stride = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Integers cell = i == 0 ? low[k] : hn::Add(low[k], integer(1));
      blocks[k][i] = hn::Mul(hn::ShiftRight<2>(cell), integer(stride));
      bits[k][i] = hn::Mul(hn::And(cell, integer(3)), integer(1 << (2 * k)));
    }
    stride *= exterior.grid().blocks[static_cast<Eigen::Index>(k)];
  }
  hn::Mask<DI> touches = integer_mask(empty_mask());
  for (std::size_t cell = 0; cell < cells_around_point; ++cell) {
    const std::size_t i = cell & 1U;
    const std::size_t j = cell >> 1U & 1U;
    const std::size_t k = cell >> 2U;
    const Integers block = hn::Add(hn::Add(blocks[0][i], blocks[1][j]), blocks[2][k]);
    const Integers bit = hn::Or(hn::Or(bits[0][i], bits[1][j]), bits[2][k]);
    const Integers state = hn::GatherIndex(di, exterior.blocks(), block);
    const hn::Mask<DI> has_triangles = hn::Gt(state, integer(-1));
    const Integers boundary_index = hn::Max(state, integer(0));
    const Integers triangle = hn::GatherIndex(di, nearest, hn::Add(hn::Mul(boundary_index, integer(block_size)), bit));
    const hn::Mask<DI> is_exterior = hn::Lt(triangle, integer(0));
    const Integers number = hn::IfThenElse(is_exterior, hn::Not(triangle), triangle);
    store(hn::IfThenElse(has_triangles, number, integer(-1)), found[cell].triangle);
    touches = hn::Or(touches,
                     hn::Or(hn::Eq(state, integer(ExteriorGrid::all_exterior)), hn::And(has_triangles, is_exterior)));
  }
  return real_mask(touches);
}

}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
