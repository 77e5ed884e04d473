// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: p sample, n its normal, p' sample raised by r, q closest point of E(r) to p', site (offset_sites.h).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "shapegauge/core/offset/nearest_offset_point.h"
#include "shapegauge/core/offset/offset_sites.h"
#include "shapegauge/core/offset/point_search.h"

namespace shapegauge {

/// Sample p with normal n whose closest exterior point q must be searched for, since p + r n and p - r n are inside the
/// offset solid. Points are in cells.
struct CoveredSample {
  Eigen::Index index;  ///< index of the sample
  Eigen::Vector3d p;   ///< position of the sample
  /// The sample moved off the surface by about the offset distance, to either side; p if it has no normal.
  std::array<Eigen::Vector3d, 2> raised;
  std::int32_t triangle;  ///< index of a triangle that probably contains p
  std::size_t group;      ///< index of the sample's group; samples of a group are consecutive and near each other
};

/// Result of a search: the point q of E(r) nearest to a raised sample, in cells, or the nearest site.
struct SearchedPoint {
  Eigen::Vector3d q;   ///< exterior point found, or the nearest site (OffsetSites)
  bool has_converged;  ///< false if no iteration converged: q is the nearest site (OffsetSites)
};

/// Searches for the closest exterior points q of covered samples, by iterations that start at sites, which are points
/// of the offset surface (docs/methods/offset_sdf.md#algorithm). Each search is in a State, and advance() is its only
/// transition:
///
///     near_sites ---> iteration <--> far_sites
///                      |     ^
///                      v     |  from another site, from the raised sample on the other side,
///                     end    +- or again from the last result if a triangle covers it
///
/// The side nearer to a site comes first, whatever the orientation of the normal. Results do not depend on the other
/// samples. Used by one thread.
class OffsetSearch {
 public:
  OffsetSearch(const ExteriorGrid& exterior, const OffsetSites& sites, ClosestTriangles& closest);

  /// Returns one result per sample, in the order of the samples. The reference is valid until the next call.
  const std::vector<SearchedPoint>& find(std::span<const CoveredSample> samples);

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static inline const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(infinity);  ///< position for no point
  static constexpr std::size_t max_starts = 9;  ///< maximum number of sites from which iterations start on one side

  /// State of a search, which is its next step.
  enum class State : std::uint8_t {
    near_sites,  ///< collect the sites nearest to the raised samples on both sides
    far_sites,   ///< collect farther sites on the current side: no iteration from the near sites has converged
    iteration,   ///< iterate from a site
    end          ///< finished
  };

  /// Progress of a search on one side of the surface.
  struct Side {
    Eigen::Vector3d raised;  ///< sample moved off the surface to this side by about the offset distance, in cells
    double distance = 0;     ///< distance from `raised` to the nearest site (OffsetSites), in cells
    std::array<NearbySites::Site, max_starts> starts{};  ///< sites from which iterations begin, nearest first
    std::size_t start_count = 0;                         ///< number of sites in `starts`
    std::size_t next_start = 0;                          ///< index in `starts` of the site to use next
    bool has_far_sites = false;                          ///< true if far sites have been collected (State::far_sites)
    Eigen::Vector3d found = nowhere;  ///< closest exterior point found from this side; infinite if none
  };

  /// Progress of the search for q of one sample.
  struct Search {
    CoveredSample sample;
    std::array<Side, 2> sides;  ///< progress on each side of the surface
    State state = State::near_sites;
    std::size_t current = 0;    ///< index in `sides` of the current side
    bool is_last_side = false;  ///< true if the search does not continue on the other side
    int repeats = 0;            ///< number of repetitions of the current iteration because a triangle covers its result
    double best = infinity;     ///< distance from the raised sample to q, in cells; infinite until a point is found
    Eigen::Vector3d q = nowhere;  ///< nearest exterior point found so far; infinite if none

    [[nodiscard]] Side& side() { return sides[current]; }
    [[nodiscard]] bool is_found() const { return best < infinity; }
  };

  /// Searches of one group of samples: those with indices from begin to before end.
  struct Group {
    std::size_t begin, end;   ///< range of indices in searches_
    Eigen::AlignedBox3d box;  ///< bounding box of the raised samples of the group
  };

  void begin(std::span<const CoveredSample> samples);
  /// Sets the starts of searches in the states near_sites and far_sites; false if there are none.
  bool collect_starts();
  void collect_starts(Search& search, const Eigen::AlignedBox3d& box);
  void measure(Search& search, const Eigen::AlignedBox3d& box);
  void set_starts(Search& search, std::size_t side, double margin, double min_spacing, std::size_t max_count);
  void iterate();
  template <typename Transition>
  void advance_all(const Transition& transition);
  State advance(Search& search, OffsetPointTask& task) const;
  State advance_from_result(Search& search, OffsetPointTask& task);
  [[nodiscard]] const NearbySites::Site* next_start(Search& search) const;
  [[nodiscard]] bool turn_to_other_side(Search& search) const;
  [[nodiscard]] std::int32_t covering_triangle(const CoveredSample& sample, const Eigen::Vector3d& x);
  void keep_nearest(Search& search, const Eigen::Vector3d& x) const;
  [[nodiscard]] Eigen::Vector3d nearest_site(const Search& search) const;

  /// Returns by how much, in cells, the result of an iteration may be closer to the raised sample than the site where
  /// the iteration starts: 0.133 times the offset distance, or 0.4 on coarse grids. Few iterations exceed this bound.
  [[nodiscard]] double gain() const { return std::max(0.4, 0.133 * r_); }
  /// Returns the maximum difference, in cells, between the distances from a raised sample to a far site and to its
  /// nearest site.
  [[nodiscard]] double far_margin() const { return 3 * gain(); }

  const ExteriorGrid& exterior_;
  const OffsetSites& sites_;
  ClosestTriangles& closest_;
  double r_;            ///< offset distance, in cells
  NearbySites nearby_;  ///< sites near the current group
  double reach_ = 0;    ///< distance from the box of the group's samples up to which `nearby_` is complete, in cells
  std::vector<NearbySites::Site> found_sites_;  ///< scratch of set_starts()
  std::vector<Search> searches_;                ///< search of each sample
  std::vector<Group> groups_;                   ///< groups of consecutive searches
  std::vector<OffsetPointTask> tasks_;          ///< iterations in progress
  std::vector<std::size_t> running_;            ///< per task: index of its search
  std::vector<SearchedPoint> results_;          ///< result of each sample
};

}  // namespace shapegauge
