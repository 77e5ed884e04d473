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
/// Lower end of the thickness histogram, in square roots of the surface's area.
inline constexpr double min_histogram_thickness = 0.005;

/// Statistics of one region: area-weighted sums over its nodes. Lengths are in square roots of the surface's area,
/// areas are fractions of the surface's area, and thickness is a natural logarithm.
struct RegionSum {
  double nodes = 0;                                    ///< number of nodes of the region
  double area = 0;                                     ///< sum of the nodes' areas, as fractions of the surface's area
  double thickness = 0;                                ///< sum of area times log thickness
  double squared_thickness = 0;                        ///< sum of area times squared log thickness
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< sum of area times position x from the surface's centroid
  Eigen::Matrix3d squared_position = Eigen::Matrix3d::Zero();  ///< sum of area times x x^T of positions x
  Eigen::Matrix3d squared_normal = Eigen::Matrix3d::Zero();    ///< sum of area times n n^T of unit normals n
  /// Area of the nodes in each bin of log thickness (thickness_bins); values outside are in the first or last bin.
  Eigen::Array<double, thickness_bins, 1> histogram = Eigen::Array<double, thickness_bins, 1>::Zero();

  RegionSum& operator+=(const RegionSum& other);  ///< makes this the sum of the union of both regions
};

/// Statistics of a pair of regions a and b, or of one region (a = b). Sample pairs have one sample in a and one in b
/// and are weighted by the product of the samples' areas. Lengths are in square roots of the surface's area.
enum class PairSum : std::uint8_t {
  pairs,         ///< weight of all sample pairs: sum of the products of the samples' areas
  seen_shallow,  ///< weight of sample pairs that see each other from a tenth of the thickness below the surface
  seen_deep,     ///< weight of sample pairs that see each other from half the thickness below the surface
  seen_outside,  ///< weight of sample pairs that see each other through the exterior of the shape
  opposite,      ///< area of a whose inward rays hit b, averaged with the area of b whose inward rays hit a
  near_pairs,    ///< weight of sample pairs closer than 0.1 square roots of the surface's area
  near_tilt,     ///< sum over near_pairs of weight (n_i - n_j) . (x_j - x_i) / |x_j - x_i|, n normals; > 0: concave
  wide_pairs,    ///< weight of sample pairs closer than 0.25 square roots of the surface's area
  wide_tilt,     ///< sum over wide_pairs of weight (n_i - n_j) . (x_j - x_i) / |x_j - x_i|, n normals; > 0: concave
  border,        ///< length of the common border of a and b
  concave,       ///< sum over the concave border of length times angle across it (radians, at most 1.5)
  convex,        ///< sum over the convex border of length times angle across it (radians, at most 1.5)
  folded,        ///< length of the common border where it is concave by more than 0.1 radians
  thickness      ///< sum over the common border of length times log thickness
};
inline constexpr std::size_t pair_sums = 14;  ///< number of enumerators of PairSum

/// Surface divided into regions, which are merged pairwise. All statistics of regions and of pairs are sums, which
/// makes merging additive.
class Regions {
 public:
  /// Creates `count` regions with statistics of zero and without neighbours.
  explicit Regions(std::int32_t count);

  /// Returns the number of regions before any merge.
  [[nodiscard]] std::int32_t initial_size() const { return static_cast<std::int32_t>(sums_.size()); }
  [[nodiscard]] std::int32_t size() const { return size_; }  ///< number of regions that remain after all merges so far

  /// Returns the number of the remaining region that contains the initial region of number `initial`.
  [[nodiscard]] std::int32_t region_of(std::int32_t initial) const;

  /// Returns the statistics of a region.
  [[nodiscard]] const RegionSum& of(std::int32_t region) const { return sums_[static_cast<std::size_t>(region)]; }
  /// Returns the statistic `what` of the pair of regions (a, b), or of one region if a == b.
  [[nodiscard]] double of(std::int32_t a, std::int32_t b, PairSum what) const {
    return pairs_[static_cast<std::size_t>(what)](a, b);
  }

  /// Returns the total length of a region's borders with all other regions, in square roots of the surface's area.
  [[nodiscard]] double perimeter(std::int32_t region) const;

  /// Returns the numbers of the regions that share a border with `region`, ascending.
  [[nodiscard]] const std::set<std::int32_t>& neighbours(std::int32_t region) const {
    return neighbours_[static_cast<std::size_t>(region)];
  }

  /// Adds `sum` to the statistics of a region.
  void add(std::int32_t region, const RegionSum& sum) { sums_[static_cast<std::size_t>(region)] += sum; }
  /// Adds `value` to the statistic `what` of the pairs (a, b) and (b, a). If a == b, adds it twice.
  void add(std::int32_t a, std::int32_t b, PairSum what, double value) {
    Eigen::MatrixXd& sums = pairs_[static_cast<std::size_t>(what)];
    sums(a, b) += value;
    sums(b, a) += value;
  }
  void make_neighbours(std::int32_t a, std::int32_t b);  ///< marks two regions as adjacent

  /// Merges region b into region a, which takes over the statistics and neighbours of b.
  void merge(std::int32_t a, std::int32_t b);

  /// Returns the merges so far, in order, as pairs: the region that remained, and the region merged into it.
  [[nodiscard]] const std::vector<std::pair<std::int32_t, std::int32_t>>& merges() const { return merges_; }

 private:
  std::int32_t size_;                                          ///< number of remaining regions
  std::vector<RegionSum> sums_;                                ///< statistics of each region
  std::array<Eigen::MatrixXd, pair_sums> pairs_;               ///< for each PairSum: its values, regions x regions
  std::vector<std::set<std::int32_t>> neighbours_;             ///< per region: numbers of adjacent regions
  std::vector<std::int32_t> merged_into_;                      ///< per region: region it was merged into, or itself
  std::vector<std::pair<std::int32_t, std::int32_t>> merges_;  ///< merges in order: remaining and merged region
};

}  // namespace shapegauge
