// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/spatial/morton_order.h"

#include <algorithm>
#include <numeric>

namespace shapegauge {

namespace {

constexpr int bits_per_axis = 21;

/// Spreads the lowest 21 bits, with two zeros after each: halves of runs of bits move apart, from 32 bits down to one.
std::uint64_t spread(std::uint64_t bits) {
  static_assert(bits_per_axis <= 21);
  bits = (bits | bits << 32U) & 0x001f00000000ffffULL;
  bits = (bits | bits << 16U) & 0x001f0000ff0000ffULL;
  bits = (bits | bits << 8U) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4U) & 0x10c30c30c30c30c3ULL;
  return (bits | bits << 2U) & 0x1249249249249249ULL;
}

}  // namespace

std::vector<std::uint64_t> morton_codes(const Points& points) {
  std::vector<std::uint64_t> codes(static_cast<std::size_t>(points.rows()), 0);
  if (points.rows() < 2) return codes;
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const double size = (points.colwise().maxCoeff() - low).maxCoeff();
  if (!(size > 0)) return codes;
  constexpr double cells = (1U << bits_per_axis) - 1;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const Eigen::RowVector3d cell = (points.row(static_cast<Eigen::Index>(i)) - low) / size * cells;
    for (int k = 0; k < 3; ++k) codes[i] |= spread(static_cast<std::uint64_t>(cell[k])) << k;
  }
  return codes;
}

std::vector<std::int32_t> morton_order(const Points& points) {
  const std::vector<std::uint64_t> codes = morton_codes(points);
  std::vector<std::int32_t> order(codes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
    return codes[static_cast<std::size_t>(i)] < codes[static_cast<std::size_t>(j)];
  });
  return order;
}

}  // namespace shapegauge
