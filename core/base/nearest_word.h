#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace shapegauge {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other, upper and
/// lower case being equal (optimal string alignment distance).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that was probably meant: the one with the fewest edits, if those are few for the word's length; the
/// first of equals.
std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> candidates);

/// What to add to a message about an unknown word: `; did you mean "offset"?` where a candidate is near, else
/// `; known here: "at", "offset"`, and nothing where there are no candidates.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace shapegauge
