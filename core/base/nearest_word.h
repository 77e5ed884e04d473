// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace shapegauge {

/// Returns the optimal string alignment distance, ignoring case: the minimum number of insertions, deletions,
/// substitutions and swaps of adjacent characters that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the candidate with the smallest edit distance to a word, the first of equal ones. Returns nothing if the
/// distance exceeds both 2 and a third of the word's length, or reaches the candidate's length.
std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> candidates);

/// Returns the end of a message about an unknown word, for users to correct it: `; did you mean "offset"?` if a
/// candidate is near, otherwise `; known here: "at", "offset"`. Empty without candidates.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

/// Formats the message about an unknown word of a kind, such as "field", with the suggestion(): `there is no field
/// "ofset"; did you mean "offset"?`. Quotes 40 bytes of the word at most.
std::string unknown_word_message(std::string_view kind, std::string_view word, std::span<const std::string> candidates);

}  // namespace shapegauge
