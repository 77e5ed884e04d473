#include "shapegauge/experiments/matrices/text_matrix.h"

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/text/lines.h"

namespace shapegauge {

DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source, TableShape shape) {
  NumberRows rows(source, shape);
  std::size_t number = 0;
  for (std::string_view line : split_lines(text)) {
    ++number;
    line = without_outer_blanks(line);
    if (line.empty() || line.starts_with('#')) continue;
    while (!line.empty()) {
      const std::string_view word = line.substr(0, line.find_first_of(" \t"));
      rows.add_number(word, number);
      line = without_outer_blanks(line.substr(word.size()));
    }
    rows.end_row(number);
  }
  return rows.matrix();
}

DistanceMatrix read_text_matrix(const std::filesystem::path& path) {
  return parse_text_matrix(read_file_bytes(path), path.string());
}

}  // namespace shapegauge
