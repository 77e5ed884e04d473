#include "shapegauge/experiments/cache/cache_entry.h"

#include <fmt/format.h>

#include "shapegauge/experiments/results/sha256.h"

namespace shapegauge {

namespace {

/// All that comes before the content.
std::string header_of(EntryKind kind, std::string_view key, std::string_view content) {
  return fmt::format("shapegauge cache entry 1\n{} {}\n{} {}\n", name_of(kind), key, content.size(), sha256(content));
}

}  // namespace

std::string encode_entry(EntryKind kind, std::string_view key, std::string_view content) {
  return header_of(kind, key, content).append(content);
}

std::optional<std::string> decode_entry(EntryKind kind, std::string_view key, std::string_view bytes) {
  constexpr int lines = 3;
  std::size_t start = 0;
  for (int line = 0; line < lines; ++line) {
    const std::size_t end = bytes.find('\n', start);
    if (end == std::string_view::npos) return std::nullopt;
    start = end + 1;
  }
  const std::string_view content = bytes.substr(start);
  if (bytes.substr(0, start) != header_of(kind, key, content)) return std::nullopt;
  return std::string(content);
}

}  // namespace shapegauge
