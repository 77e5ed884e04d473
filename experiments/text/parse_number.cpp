#include "shapegauge/experiments/text/parse_number.h"

#include <charconv>
#include <system_error>

namespace shapegauge {

std::optional<double> parse_number(std::string_view word) {
  // A plus sign is common in files, but std::from_chars does not take one.
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace shapegauge
