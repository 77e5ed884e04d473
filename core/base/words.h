// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Words of enumerations in files, options and messages: one list next to each enumeration.

namespace shapegauge {

/// Names of the values 0, 1, 2, ... of an enumeration. Specialised next to each enumeration that has words.
template <typename Enumeration>
inline constexpr std::array<std::string_view, 0> words_of{};

/// Returns the word of an enumeration value (words_of).
template <typename Enumeration>
constexpr std::string_view word_of(Enumeration value) {
  return words_of<Enumeration>.at(static_cast<std::size_t>(value));
}

/// Returns the word of an enumeration value (words_of) as a string.
template <typename Enumeration>
requires(words_of<Enumeration>.size() > 0) std::string name_of(Enumeration value) {
  return std::string(word_of(value));
}

/// Returns the enumeration value that a word names; nothing for an unknown word.
template <typename Enumeration>
constexpr std::optional<Enumeration> value_of_word(std::string_view word) {
  for (std::size_t i = 0; i < words_of<Enumeration>.size(); ++i) {
    if (words_of<Enumeration>[i] == word) return static_cast<Enumeration>(i);
  }
  return std::nullopt;
}

/// Returns the words of all values of an enumeration, for options and messages.
template <typename Enumeration>
std::vector<std::string> list_of_words() {
  return {words_of<Enumeration>.begin(), words_of<Enumeration>.end()};
}

}  // namespace shapegauge
