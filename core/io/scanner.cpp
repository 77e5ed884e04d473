// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/scanner.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

/// Parses a number out of range. std::from_chars does not distinguish overflow from underflow; a stream returns 0 for
/// the latter.
double value_out_of_range(const char* first, const char* last) {
  std::istringstream stream(std::string(first, last));
  stream.imbue(std::locale::classic());
  double value = std::numeric_limits<double>::infinity();
  return stream >> value ? value : std::numeric_limits<double>::infinity();
}

/// Maximum length of a message, which may contain arbitrary words of the file.
constexpr std::size_t longest_message = 300;

/// Returns the beginning of the number: std::from_chars does not accept a plus sign.
const char* without_plus(const char* word) { return *word == '+' && word[1] != '-' ? word + 1 : word; }

}  // namespace

bool TextScanner::read_number(double& value, std::string_view role) {
  if (at_end()) return false;
  word_ = position_;
  const char* const first = without_plus(position_);
  const auto [last, error] = std::from_chars(first, end_, value);
  if (error == std::errc::result_out_of_range) value = value_out_of_range(first, last);
  if (error == std::errc::invalid_argument || !ends_number(last)) {
    fail(fmt::format("expected {}, found \"{}\"", role, current_word()));
  }
  if (!std::isfinite(value)) {
    fail(fmt::format("{} is not a finite number: \"{}\"; repair or remove the file", role, current_word()));
  }
  position_ = last;
  return true;
}

bool TextScanner::read_integer(std::int64_t& value, std::string_view role) {
  if (at_end()) return false;
  word_ = position_;
  const auto [last, error] = std::from_chars(without_plus(position_), end_, value);
  if (error != std::errc() || !ends_number(last)) {
    fail(fmt::format("expected {} (a whole number), found \"{}\"", role, current_word()));
  }
  position_ = last;
  return true;
}

std::string_view TextScanner::read_word() {
  if (at_end()) return {};
  word_ = position_;
  const std::string_view word = current_word();
  position_ += word.size();
  return word;
}

bool TextScanner::skip_words(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (read_word().empty()) return false;
  }
  return true;
}

std::string_view TextScanner::current_word() const {
  const char* last = word_;
  while (last != end_ && !is_space(*last)) ++last;
  return {word_, static_cast<std::size_t>(last - word_)};
}

void TextScanner::fail_at(std::size_t offset, std::string_view message) const {
  std::size_t line = 1;
  for (const char* p = begin_; p != begin_ + offset; ++p) {
    if (*p == '\n' || (*p == '\r' && p[1] != '\n')) ++line;
  }
  throw InputError(fmt::format("{}:{}: {}", *name_, line, printable(message, longest_message)));
}

void TextScanner::fail_whole(std::string_view message) const {
  throw InputError(fmt::format("{}: {}", *name_, printable(message, longest_message)));
}

}  // namespace shapegauge
