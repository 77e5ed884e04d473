// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/nearest_word.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace shapegauge {

namespace {

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) edits[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) edits[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = edits[i - 1][j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      edits[i][j] = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1])) {
        edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
      }
    }
  }
  return edits[a.size()][b.size()];
}

std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> candidates) {
  // Time and memory grow with the product of the lengths; realistic words are short.
  constexpr std::size_t longest = 100;
  std::optional<std::string> nearest;
  // Tolerates a third of the letters, and at least two errors: "offst", but not "rays_count" for "rays".
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (std::max(word.size(), candidate.size()) > longest) continue;
    const std::size_t edits = edit_distance(word, candidate);
    if (edits < fewest && edits < candidate.size()) {
      fewest = edits;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  if (candidates.empty()) return {};
  if (const auto nearest = nearest_word(word, candidates)) return fmt::format("; did you mean \"{}\"?", *nearest);
  return fmt::format("; known here: \"{}\"", fmt::join(candidates, "\", \""));
}

std::string unknown_word_message(std::string_view kind, std::string_view word,
                                 std::span<const std::string> candidates) {
  return fmt::format("there is no {} \"{}\"{}", kind, word.substr(0, 40), suggestion(word, candidates));
}

}  // namespace shapegauge
