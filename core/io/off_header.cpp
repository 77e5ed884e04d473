#include "shapegauge/core/io/off_header.h"

#include <fmt/format.h>
#include <limits>
#include <string_view>

namespace shapegauge {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the prefix off the front of the text, if it is there.
bool consume(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

struct Keyword {
  OffHeader header;
  bool dimensions = false;  // 4OFF, nOFF
  std::size_t length = 0;   // 0: there is none
};

/// [ST][C][N][4][n]OFF, the letters in any order.
Keyword parse_keyword(std::string_view text) {
  Keyword keyword;
  std::string_view rest = text;
  if (consume(rest, "off")) {
    keyword.length = 3;
    return keyword;
  }
  while (!consume(rest, "OFF")) {
    if (consume(rest, "ST")) {
      keyword.header.texture = true;
    } else if (consume(rest, "C")) {
      keyword.header.colours = true;
    } else if (consume(rest, "N")) {
      keyword.header.normals = true;
    } else if (consume(rest, "4") || consume(rest, "n")) {
      keyword.dimensions = true;
    } else {
      return {};
    }
  }
  keyword.length = text.size() - rest.size();
  return keyword;
}

bool ends_keyword(std::string_view rest) {
  return rest.empty() || is_digit(rest.front()) ||
         std::string_view(" \t\r\n#").find(rest.front()) != std::string_view::npos;
}

/// True where the next line that is not blank holds exactly one word.
bool single_word_on_line(TextScanner scanner) { return !scanner.read_word().empty() && scanner.at_line_end(); }

}  // namespace

OffHeader read_off_header(TextScanner& scanner) {
  if (scanner.at_end()) scanner.fail_whole("holds nothing but white space and comments");
  const Keyword keyword = parse_keyword(scanner.rest());
  const std::string_view behind = scanner.rest().substr(keyword.length);
  if (keyword.length == 0 ? !is_digit(scanner.rest().front()) : !ends_keyword(behind)) {
    scanner.advance(0);
    scanner.fail("not an OFF file: it begins neither with the keyword OFF nor with the number of vertices");
  }
  scanner.advance(keyword.length);
  if (keyword.dimensions)
    scanner.fail("4OFF and nOFF files hold points of other than three dimensions; convert it to OFF");
  OffHeader header = keyword.header;
  if (keyword.length > 0 && !scanner.at_line_end() && scanner.rest().starts_with("BINARY")) {
    scanner.read_word();
    header.binary = true;
  }
  return header;
}

OffCounts read_off_counts(TextScanner& scanner, OffLayout layout) {
  OffCounts counts;
  if (!scanner.read_integer(counts.vertices, "the number of vertices") ||
      !scanner.read_integer(counts.faces, "the number of faces")) {
    scanner.fail_whole("ends before the numbers of vertices and faces");
  }
  check_off_counts(counts, scanner);
  if (layout == OffLayout::lines && !scanner.at_line_end()) {
    scanner.skip_line();
  } else if (layout == OffLayout::words || single_word_on_line(scanner)) {
    scanner.skip_words(1);  // the number of edges, perhaps on a line of its own
  }
  return counts;
}

void check_off_counts(const OffCounts& counts, const TextScanner& scanner) {
  constexpr std::int64_t largest = std::numeric_limits<std::int32_t>::max();
  if (counts.vertices < 0 || counts.faces < 0) {
    scanner.fail(fmt::format("{} vertices and {} faces: neither can be negative", counts.vertices, counts.faces));
  }
  if (counts.vertices > largest || counts.faces > largest) {
    scanner.fail(fmt::format("{} vertices and {} faces: at most {} of each can be read", counts.vertices, counts.faces,
                             largest));
  }
}

}  // namespace shapegauge
