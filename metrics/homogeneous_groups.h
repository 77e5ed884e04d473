// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace shapegauge {

/// Consecutive members of a ranking that do not differ significantly: positions `first` to `last`, inclusive, where 0
/// is the best.
struct HomogeneousGroup {
  std::size_t first = 0;  ///< position of the best member in the ranking, from 0
  std::size_t last = 0;   ///< position of the worst member in the ranking, from 0

  bool operator==(const HomogeneousGroup&) const = default;
};

/// Returns the maximal groups of consecutive members of a ranking in which no two differ significantly, best group
/// first. No group contains another, and each of the `count` members is in at least one. differ(i, j) with i < j
/// returns whether the members at positions i and j differ significantly. It must be monotone: if positions i and j
/// differ, so do all pairs that enclose them. Comparing differences with one critical value satisfies this.
std::vector<HomogeneousGroup> homogeneous_groups(std::size_t count,
                                                 const std::function<bool(std::size_t i, std::size_t j)>& differ);

/// Returns the compact letter display of a ranking of `count` members, one string per position: members that share a
/// letter do not differ significantly. Groups are named a, b, ... z, aa, ab, .... A member of up to three groups has
/// their letters ("ab"); a member of more groups, which are consecutive, has the first and the last letter ("c-g").
/// Piepho, "An algorithm for a letter-based representation of all-pairwise comparisons", Journal of Computational and
/// Graphical Statistics 13, 2004.
std::vector<std::string> compact_letters(std::size_t count, std::span<const HomogeneousGroup> groups);

}  // namespace shapegauge
