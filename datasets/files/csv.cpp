// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/csv.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

constexpr std::string_view separator_line = "sep=";

// Returns the separator that a first line "sep=;" declares, as Excel writes it.
std::optional<char> declared_separator(std::string_view text) {
  text = without_byte_order_mark(text);
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  if (line.size() != separator_line.size() + 1 || !line.starts_with(separator_line)) return std::nullopt;
  return line.back();
}

// Returns true for a text that, behind any apostrophes, a spreadsheet takes as a formula: it begins with =, @, or a
// sign that belongs to no number.
bool is_formula(std::string_view text) {
  const bool is_protected = text.starts_with('\'');
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  if (text.size() < 2) return false;
  if (text.front() == '=' || text.front() == '@') return true;
  return (text.front() == '+' || text.front() == '-') &&
         (is_protected || !parse_number(text.substr(0, text.find(' '))));
}

}  // namespace

CsvReader::CsvReader(std::string_view text, std::string source, char separator)
    : rest_(without_byte_order_mark(text)),
      source_(std::move(source)),
      separator_(separator),
      line_end_(rest_.find('\n') == std::string_view::npos ? '\r' : '\n'),
      cell_ends_({separator, line_end_}) {
  if (declared_separator(text)) read_row();
}

std::optional<CsvRow> CsvReader::next() {
  while (!rest_.empty()) {
    CsvRow row = read_row();
    const bool blank = !quoted_ && std::ranges::all_of(row.cells, &std::string::empty);
    if (!blank) return row;
  }
  return std::nullopt;
}

CsvRow CsvReader::read_row() {
  CsvRow row{.cells = {}, .line = line_};
  quoted_ = false;
  while (true) {
    if (row.cells.size() == max_csv_cells) fail(line_, fmt::format("the row has more than {} cells", max_csv_cells));
    skip_blanks();
    row.cells.push_back(rest_.starts_with('"') ? read_quoted_cell() : std::string(read_to_cell_end()));
    if (row.cells.back().starts_with('\'') && is_formula(row.cells.back())) row.cells.back().erase(0, 1);
    const bool more = rest_.starts_with(separator_);
    if (!more) ++line_;
    rest_.remove_prefix(rest_.empty() ? 0 : 1);
    if (!more) return row;
  }
}

void CsvReader::skip_blanks() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
}

// Blanks that are the separator are not blanks.
bool CsvReader::is_blank(char c) const { return (c == ' ' || c == '\t') && c != separator_; }

// Returns the cell up to the separator or the line end, which stays.
std::string_view CsvReader::read_to_cell_end() {
  std::string_view cell = rest_.substr(0, rest_.find_first_of(cell_ends_));
  rest_.remove_prefix(cell.size());
  const bool line_ends = rest_.empty() || rest_.front() == line_end_;
  if (line_ends && cell.ends_with('\r')) cell.remove_suffix(1);
  while (!cell.empty() && is_blank(cell.back())) cell.remove_suffix(1);
  return cell;
}

std::string CsvReader::read_quoted_cell() {
  quoted_ = true;
  const std::size_t first_line = line_;
  std::string cell;
  while (true) {
    const std::size_t quote = rest_.find('"', 1);
    if (quote == std::string_view::npos) {
      fail(first_line,
           "the quotation mark in front of " + quoted_word(cell.empty() ? rest_.substr(1) : cell) + " is not closed");
    }
    const std::string_view part = rest_.substr(1, quote - 1);
    cell += part;
    line_ += static_cast<std::size_t>(std::ranges::count(part, line_end_));
    rest_.remove_prefix(quote + 1);
    if (!rest_.starts_with('"')) break;
    cell += '"';
  }
  skip_blanks();
  const std::string_view behind = read_to_cell_end();
  if (!behind.empty()) {
    fail(line_, quoted_word(behind) + " follows a closing quotation mark; put a separator between them");
  }
  return cell;
}

void CsvReader::fail(std::size_t line, const std::string& message) const {
  throw InputError(source_ + ':' + std::to_string(line) + ": " + message);
}

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& source) {
  CsvReader reader(text, source, ',');
  std::vector<CsvRow> rows;
  while (auto row = reader.next()) rows.push_back(std::move(*row));
  return rows;
}

namespace {

std::string_view first_line(std::string_view text) {
  text = without_byte_order_mark(text);
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  // A line that begins with a tab has an empty first cell.
  const std::size_t line_begin = text.substr(0, begin).find_last_of("\r\n") + 1;
  return text.substr(line_begin, text.find_first_of("\r\n", begin) - line_begin);
}

/// Returns the line without quoted text and without decimal commas.
std::string separators_only(std::string_view line) {
  std::string rest;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    const bool between_digits = i > 0 && i + 1 < line.size() && is_digit(line[i - 1]) && is_digit(line[i + 1]);
    if (!quoted && !(line[i] == ',' && between_digits)) rest += line[i];
  }
  return rest;
}

}  // namespace

std::optional<char> first_separator(std::string_view text) {
  if (const auto declared = declared_separator(text)) return declared;
  const std::string_view line = first_line(text);
  for (const char separator : {'\t', ';', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return std::nullopt;
}

std::vector<CsvRow> parse_word_table(std::string_view text, const std::string& source) {
  constexpr std::size_t max_rows = 10'000'000;
  CsvReader reader(text, source, first_separator(text).value_or(','));
  std::vector<CsvRow> rows;
  while (auto row = reader.next()) {
    if (rows.size() == max_rows) throw InputError(fmt::format("{}: more than {} rows", source, max_rows));
    rows.push_back(std::move(*row));
    if (rows.back().cells.size() == rows.front().cells.size()) continue;
    throw InputError(fmt::format("{}:{}: {} where the first row has {}", source, rows.back().line,
                                 count_text(std::ssize(rows.back().cells), "cell", "cells"),
                                 rows.front().cells.size()));
  }
  return rows;
}

std::optional<std::size_t> find_column(const CsvRow& header, std::span<const std::string_view> names) {
  const auto found = std::ranges::find_if(
      header.cells, [&](const std::string& cell) { return std::ranges::find(names, lower_case(cell)) != names.end(); });
  if (found == header.cells.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.cells.begin());
}

std::optional<std::size_t> find_class_column(const CsvRow& header, const std::string& source) {
  const std::optional<std::size_t> column = find_column(header, class_column_names);
  if (!column) return column;
  CsvRow others = header;
  others.cells[*column].clear();
  if (const auto second = find_column(others, class_column_names)) {
    throw InputError(fmt::format("{}:{}: the columns {} and {} both name classes; rename one", source, header.line,
                                 quoted_word(header.cells[*column]), quoted_word(header.cells[*second])));
  }
  return column;
}

char number_separator(std::string_view text) {
  if (const auto declared = declared_separator(text)) return *declared;
  std::string_view line = first_line(text);
  line = line.substr(0, line.find_last_not_of(" \t") + 1);
  const std::string separators = separators_only(line);
  for (const char separator : {',', '\t', ';'}) {
    if (separators.find(separator) != std::string::npos) return separator;
  }
  return ',';
}

std::string csv_cell(std::string_view text) {
  const std::string_view mark = is_formula(text) ? "'" : "";
  const bool plain = text.find_first_of(",\"\r\n") == std::string_view::npos && text == trim(text);
  if (plain) return std::string(mark).append(text);
  std::string cell = "\"";
  cell += mark;
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
  // A row of empty cells is a row only with one of them in quotation marks.
  std::string line = std::ranges::all_of(cells, &std::string::empty) ? "\"\"" : "";
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) line += ',';
    line += csv_cell(cell);
  }
  return line + '\n';
}

}  // namespace shapegauge
