#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace shapegauge {

/// Members of a ranking that do not differ significantly: positions from the best one, both ends included.
struct HomogeneousGroup {
  std::size_t first = 0;
  std::size_t last = 0;

  bool operator==(const HomogeneousGroup&) const = default;
};

/// Returns the largest groups of neighbours in a ranking of `count` members in which no two differ significantly, the
/// best group first; none lies within another, and each member is in at least one. differ(i, j) with i < j says whether
/// positions i and j differ. It must be monotone: where it holds for two positions, it holds for all that lie further
/// apart on both sides, as it does where differences of one quantity are compared with one critical value.
std::vector<HomogeneousGroup> homogeneous_groups(std::size_t count,
                                                 const std::function<bool(std::size_t i, std::size_t j)>& differ);

/// Returns the compact letter display of groups, by position of `count` members: members that share a letter do not
/// differ significantly. Groups are a, b, ... z, aa, ab, ...; a member of up to three groups has their letters ("ab"),
/// one of more the first and the last ("c-g"), which stand for all between, since groups of a ranking follow each
/// other. Piepho, "An algorithm for a letter-based representation of all-pairwise comparisons", Journal of
/// Computational and Graphical Statistics 13, 2004.
std::vector<std::string> compact_letters(std::size_t count, std::span<const HomogeneousGroup> groups);

}  // namespace shapegauge
