// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/homogeneous_groups.h"

#include <algorithm>

namespace shapegauge {

namespace {

constexpr std::size_t most_letters_in_full = 3;

// a to z, then aa, ab, ...
std::string letter_of(std::size_t group) {
  constexpr std::size_t alphabet = 26;
  std::string letters(1, static_cast<char>('a' + group % alphabet));
  for (group /= alphabet; group > 0; group /= alphabet) {
    --group;
    letters.insert(letters.begin(), static_cast<char>('a' + group % alphabet));
  }
  return letters;
}

std::string letters_from(std::size_t first, std::size_t last) {
  const bool single = letter_of(last).size() == 1;
  if (first == last) return letter_of(first);
  if (!single || last - first >= most_letters_in_full) return letter_of(first) + "-" + letter_of(last);
  std::string letters;
  for (std::size_t group = first; group <= last; ++group) letters += letter_of(group);
  return letters;
}

}  // namespace

std::vector<HomogeneousGroup> homogeneous_groups(std::size_t count,
                                                 const std::function<bool(std::size_t, std::size_t)>& differ) {
  std::vector<HomogeneousGroup> groups;
  for (std::size_t first = 0; first < count; ++first) {
    std::size_t last = groups.empty() ? first : std::max(first, groups.back().last);
    while (last + 1 < count && !differ(first, last + 1)) ++last;
    if (groups.empty() || last > groups.back().last) groups.push_back({.first = first, .last = last});
  }
  return groups;
}

std::vector<std::string> compact_letters(std::size_t count, std::span<const HomogeneousGroup> groups) {
  std::vector<std::string> letters;
  for (std::size_t position = 0; position < count; ++position) {
    const auto holds = [&](const HomogeneousGroup& group) { return group.first <= position && position <= group.last; };
    const auto first = std::ranges::find_if(groups, holds);
    const auto after = std::find_if_not(first, groups.end(), holds);
    letters.push_back(first == groups.end() ? ""
                                            : letters_from(static_cast<std::size_t>(first - groups.begin()),
                                                           static_cast<std::size_t>(after - groups.begin()) - 1));
  }
  return letters;
}

}  // namespace shapegauge
