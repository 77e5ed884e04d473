// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace shapegauge {

/// Number of bins of a region's thickness histogram: log-spaced from 0.005 to 1 times the square root of the surface's
/// area.
inline constexpr int thickness_bins = 32;
inline constexpr double lowest_thickness = 0.005;

/// Sums over the nodes of a region, weighted by area except for `nodes`. Lengths are in square roots of the surface's
/// area, areas are shares of it, and thickness is its natural logarithm.
struct RegionSum {
  double nodes = 0;
  double area = 0;
  double thickness = 0;
  double squared_thickness = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squared_position = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d squared_normal = Eigen::Matrix3d::Zero();
  Eigen::Array<double, thickness_bins, 1> histogram = Eigen::Array<double, thickness_bins, 1>::Zero();

  RegionSum& operator+=(const RegionSum& other);
};

/// Sums over pairs of points or nodes, one in each of two regions, or both in one.
enum class PairSum : std::uint8_t {
  pairs,         ///< pairs of samples, weighted by the product of their areas
  seen_shallow,  ///< pairs that see each other from just below the surface
  seen_deep,     ///< pairs that see each other from half way into the shape
  seen_outside,  ///< pairs that see each other through the outside
  opposite,      ///< of nodes: area whose inward ray hits the other region, in either direction
  near_pairs,    ///< pairs of samples closer than 0.1
  near_tilt,     ///< over near_pairs: sine of the tilt of normals towards each other, positive in a concavity
  wide_pairs,    ///< pairs of samples closer than 0.25
  wide_tilt,     ///< as near_tilt, over wide_pairs
  border,        ///< length of the common border
  concave,       ///< over the border: its angle where concave, in radians
  convex,        ///< over the border: its angle where convex, in radians
  folded,        ///< length of the border where its concave angle exceeds 0.1
  thickness      ///< over the border
};
inline constexpr std::size_t pair_sums = 14;

/// Surface divided into regions, which are merged pairwise. All statistics of regions and of pairs are sums, which
/// makes merging additive.
class Regions {
 public:
  /// Creates `count` regions without statistics.
  explicit Regions(std::int32_t count);

  [[nodiscard]] std::int32_t initial_size() const { return static_cast<std::int32_t>(sums_.size()); }
  [[nodiscard]] std::int32_t size() const { return size_; }  ///< number of remaining regions

  /// Returns the region that an initial region was merged into.
  [[nodiscard]] std::int32_t region_of(std::int32_t initial) const;

  [[nodiscard]] const RegionSum& of(std::int32_t region) const { return sums_[static_cast<std::size_t>(region)]; }
  [[nodiscard]] double of(std::int32_t a, std::int32_t b, PairSum what) const {
    return pairs_[static_cast<std::size_t>(what)](a, b);
  }

  /// Returns the length of a region's border with all others.
  [[nodiscard]] double perimeter(std::int32_t region) const;

  /// Returns the regions that share a border with this one, ascending.
  [[nodiscard]] const std::set<std::int32_t>& neighbours(std::int32_t region) const {
    return neighbours_[static_cast<std::size_t>(region)];
  }

  /// Adds to the statistics of a region.
  void add(std::int32_t region, const RegionSum& sum) { sums_[static_cast<std::size_t>(region)] += sum; }
  /// Adds to a statistic of the pairs (a, b) and (b, a); within a region (a == b), adds twice.
  void add(std::int32_t a, std::int32_t b, PairSum what, double value) {
    Eigen::MatrixXd& sums = pairs_[static_cast<std::size_t>(what)];
    sums(a, b) += value;
    sums(b, a) += value;
  }
  void make_neighbours(std::int32_t a, std::int32_t b);

  /// Merges b into a.
  void merge(std::int32_t a, std::int32_t b);

  /// Returns the merges so far: the region kept and the one merged into it.
  [[nodiscard]] const std::vector<std::pair<std::int32_t, std::int32_t>>& merges() const { return merges_; }

 private:
  std::int32_t size_;
  std::vector<RegionSum> sums_;
  std::array<Eigen::MatrixXd, pair_sums> pairs_;
  std::vector<std::set<std::int32_t>> neighbours_;
  std::vector<std::int32_t> merged_into_;
  std::vector<std::pair<std::int32_t, std::int32_t>> merges_;
};

}  // namespace shapegauge
