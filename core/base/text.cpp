// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <system_error>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::vector<std::string_view> split_lines(std::string_view text) {
  text = without_byte_order_mark(text);
  const char line_end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(line_end), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::optional<double> parse_number(std::string_view word) {
  // A plus sign is common in files, but std::from_chars does not take one.
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::string count_text(std::int64_t count, std::string_view one, std::string_view several) {
  return std::to_string(count).append(" ").append(count == 1 ? one : several);
}

std::string two_digits(double number) {
  const bool is_short = std::abs(number) < 99.5 || std::abs(number) >= 1e6;
  return is_short ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number);
}

std::string plain_number(double number, int digits) {
  const double size = std::abs(number);
  if (size == 0) return "0";
  if (!(size >= 1e-9 && size < 1e15)) return fmt::format("{:.{}g}", number, digits);
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(size)));
  const double unit = std::pow(10, -decimals);
  std::string text =
      decimals < 0 ? fmt::format("{:.0f}", std::round(number / unit) * unit) : fmt::format("{:.{}f}", number, decimals);
  if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string quoted_word(std::string_view word) { return '"' + printable(word, 40) + '"'; }

}  // namespace shapegauge
