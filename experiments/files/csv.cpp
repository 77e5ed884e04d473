#include "shapegauge/experiments/files/csv.h"

#include <algorithm>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

// Takes a cell in quotation marks from the front of the line, up to the comma behind it or the end.
std::string take_quoted_cell(std::string_view& line, const std::string& where) {
  std::string cell;
  std::size_t position = 1;
  while (true) {
    const std::size_t quote = line.find('"', position);
    if (quote == std::string_view::npos) {
      throw InputError(where + ": the quotation mark in front of " + quoted_word(line.substr(1)) + " is not closed");
    }
    cell += line.substr(position, quote - position);
    position = quote + 1;
    if (!line.substr(position).starts_with('"')) break;
    cell += '"';
    ++position;
  }
  const std::size_t comma = std::min(line.find(',', position), line.size());
  const std::string_view rest = trim(line.substr(position, comma - position));
  if (!rest.empty()) {
    throw InputError(where + ": " + quoted_word(rest) + " follows a closing quotation mark; put a comma between them");
  }
  line.remove_prefix(comma);
  return cell;
}

}  // namespace

std::vector<std::string> split_csv_line(std::string_view line, const std::string& where) {
  std::vector<std::string> cells;
  while (true) {
    line = trim(line);
    if (line.starts_with('"')) {
      cells.push_back(take_quoted_cell(line, where));
    } else {
      const std::size_t comma = std::min(line.find(','), line.size());
      cells.emplace_back(trim(line.substr(0, comma)));
      line.remove_prefix(comma);
    }
    if (line.empty()) return cells;
    line.remove_prefix(1);
  }
}

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& source) {
  std::vector<CsvRow> rows;
  std::size_t number = 0;
  for (const std::string_view line : split_lines(text)) {
    ++number;
    if (trim(line).empty()) continue;
    rows.push_back({split_csv_line(line, source + ':' + std::to_string(number)), number});
  }
  return rows;
}

std::string csv_cell(std::string_view text) {
  const bool plain = text.find_first_of(",\"") == std::string_view::npos && text == trim(text);
  if (plain) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) line += ',';
    line += csv_cell(cell);
  }
  return line + '\n';
}

}  // namespace shapegauge
