// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/text_matrices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <unordered_set>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/csv.h"

namespace shapegauge {

namespace {

// Returns true for a cell that stands for no number.
bool is_missing(std::string_view word) {
  static constexpr std::array<std::string_view, 6> words{"", "na", "nan", "n/a", "null", "-"};
  return std::ranges::find(words, lower_case(std::string(word))) != words.end();
}

// Returns whether the word is an integer, beyond 2^53, that is not the number.
bool is_rounded_integer(std::string_view word, double number) {
  constexpr double largest = 9007199254740992.0;  // 2^53
  if (std::abs(number) < largest || word.find_first_not_of("+-0123456789") != std::string_view::npos) return false;
  return fmt::format("{:.0f}", std::abs(number)) != word.substr(word.find_first_not_of("+-0"));
}

// Assembles a matrix from the rows of a text file; errors have file and line. Of a square one, entries on the diagonal
// may be missing.
class NumberRows {
 public:
  NumberRows(const std::string& source, TableShape shape) : source_(&source), shape_(shape) {}

  // Adds the next number, from a line with that separator, to the current row.
  void add_number(std::string_view word, std::size_t line, char separator) {
    const bool on_diagonal = shape_ == TableShape::square && numbers_.size() - row_begin_ == rows_;
    const auto number = on_diagonal && is_missing(word) ? 0.0 : parse_number(word);
    if (!number) {
      // Of "0,5 1,2", the commas seem to be the separators.
      const bool decimal_comma = word.find(separator == ',' ? ' ' : ',') != std::string_view::npos;
      throw InputError(fmt::format("{}:{}: {} is not a number (number {} of the row){}", *source_, line,
                                   quoted_word(word), numbers_.size() - row_begin_ + 1,
                                   decimal_comma ? "; write decimal points, not commas" : ""));
    }
    if (is_rounded_integer(word, *number)) {
      throw InputError(fmt::format("{}:{}: the integer {} is beyond 2^53, where numbers are rounded; scale the numbers",
                                   *source_, line, quoted_word(word)));
    }
    numbers_.push_back(*number);
  }

  void end_row(std::size_t line) {
    const std::size_t length = numbers_.size() - row_begin_;
    if (length == 0) throw InputError(fmt::format("{}:{}: the row has no numbers", *source_, line));
    if (rows_ == 0) {
      columns_ = length;
      first_line_ = line;
    }
    if (length != columns_) {
      throw InputError(fmt::format("{0}:{1}: expected {4} numbers as in line {3}, found {2}", *source_, line, length,
                                   first_line_, columns_));
    }
    if (shape_ == TableShape::square && rows_ == columns_) {
      throw InputError(fmt::format("{}:{}: expected a square distance matrix, found row {} with rows of {} numbers",
                                   *source_, line, rows_ + 1, columns_));
    }
    ++rows_;
    row_begin_ = numbers_.size();
  }

  [[nodiscard]] DistanceMatrix matrix() const {
    if (rows_ == 0) throw InputError(fmt::format("{}: the file has no numbers", *source_));
    if (shape_ == TableShape::square && rows_ != columns_) {
      throw InputError(fmt::format("{}: expected a square distance matrix, found {} of {}; the file may be truncated",
                                   *source_, count_text(static_cast<std::int64_t>(rows_), "row", "rows"),
                                   count_text(static_cast<std::int64_t>(columns_), "number", "numbers")));
    }
    return Eigen::Map<const DistanceMatrix>(numbers_.data(), static_cast<Eigen::Index>(rows_),
                                            static_cast<Eigen::Index>(columns_));
  }

 private:
  const std::string* source_;
  TableShape shape_;
  std::vector<double> numbers_;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t first_line_ = 0;
  std::size_t row_begin_ = 0;
};

bool is_number(const std::string& cell) { return parse_number(cell).has_value(); }

// Reader of rows of numbers, all of which may end with a separator.
class NumberRowReader {
 public:
  NumberRowReader(std::string_view text, const std::string& source, char separator)
      : reader_(text, source, separator) {}

  std::optional<CsvRow> next() {
    std::optional<CsvRow> row = reader_.next();
    if (!row || row->cells.size() < 2) return row;
    const bool ends_with_separator = row->cells.back().empty();
    if (!all_end_with_separator_) all_end_with_separator_ = ends_with_separator;
    if (*all_end_with_separator_ && ends_with_separator) row->cells.pop_back();
    return row;
  }

 private:
  CsvReader reader_;
  std::optional<bool> all_end_with_separator_;
};

// Returns true for the first row of distances, whose missing diagonal entry is not the corner above ids: the other
// cells are numbers that repeat, or not all of them whole.
bool lacks_diagonal(const CsvRow& first) {
  if (first.cells.size() < 2 || !is_missing(first.cells.front())) return false;
  const auto others = std::span(first.cells).subspan(1);
  if (!std::ranges::all_of(others, is_number)) return false;
  const auto is_whole = [](const std::string& cell) {
    return cell.find_first_not_of("0123456789") == std::string::npos;
  };
  return !std::ranges::all_of(others, is_whole) || std::set(others.begin(), others.end()).size() < others.size();
}

void check_ids(const std::vector<std::string>& ids, const std::string& where) {
  std::unordered_set<std::string_view> seen;
  for (const std::string& id : ids) {
    if (id.empty()) throw InputError(fmt::format("{}: an id is empty", where));
    if (!seen.insert(id).second) throw InputError(fmt::format("{}: repeated id {}", where, quoted_word(id)));
  }
}

// Returns the ids of the columns, after the first cell of the header row.
std::vector<std::string> read_ids(const CsvRow& header, const std::string& source) {
  std::vector<std::string> ids(header.cells.begin() + 1, header.cells.end());
  check_ids(ids, fmt::format("{}:{}", source, header.line));
  return ids;
}

[[noreturn]] void fail_without_separator(const CsvRow& row, const std::string& source) {
  throw InputError(fmt::format(
      "{}:{}: {} is neither a number nor a row of ids; a CSV matrix needs commas, semicolons or tabs between "
      "its numbers",
      source, row.line, quoted_word(row.cells.front())));
}

// Throws InputError if the first row, which does not begin with a number, has no ids of columns.
void check_header(const CsvRow& header, const std::optional<CsvRow>& second, const std::string& source) {
  const bool other_length = second && second->cells.size() != header.cells.size();
  if (header.cells.front().starts_with('#') && other_length) {
    throw InputError(fmt::format("{}:{}: a CSV matrix has no comments; remove the line", source, header.line));
  }
  if (header.cells.size() > 1 || !second) return;
  fail_without_separator(header, source);
}

void check_row_id(const CsvRow& row, std::size_t index, const std::vector<std::string>& ids,
                  const std::string& source) {
  if (index >= ids.size()) {
    throw InputError(
        fmt::format("{}:{}: there are more rows than the {} ids of the header row", source, row.line, ids.size()));
  }
  if (row.cells.front() == ids[index]) return;
  throw InputError(
      fmt::format("{}:{}: the row has the id {}, but the corresponding column has {}; rows and columns must have the "
                  "same ids in the same order",
                  source, row.line, quoted_word(row.cells.front()), quoted_word(ids[index])));
}

bool names_ids(const std::string& cell) { return cell.empty() || cell == "id"; }

// Throws InputError for a row whose numbers are separated by blanks or bars.
void check_separator(const CsvRow& row, const std::string& source) {
  const std::string& cell = row.cells.front();
  if (row.cells.size() > 1 || is_number(cell) || cell.find_first_of("| ") == std::string::npos) return;
  fail_without_separator(row, source);
}

bool is_header(const CsvRow& first) {
  const std::vector<std::string>& cells = first.cells;
  if (is_number(cells.front())) return false;
  if (cells.size() == 1) return true;  // a name alone is not an id with numbers
  return names_ids(cells.front()) || !std::all_of(cells.begin() + 1, cells.end(), is_number);
}

// Throws InputError if a column of numbers, from `first` on, is named as that of classes.
void check_no_classes(CsvRow header, std::ptrdiff_t first, const std::string& source) {
  header.cells.erase(header.cells.begin(), header.cells.begin() + first);
  const auto column = find_column(header, class_column_names);
  if (!column) return;
  throw InputError(fmt::format(
      "{}:{}: the column {} has classes, which are no features; remove it, and give the classes as `labels`", source,
      header.line, quoted_word(header.cells[*column])));
}

// Returns the separator of numbers: a semicolon or comma if the line has one, otherwise a blank.
char separator_of_line(std::string_view line) {
  for (const char separator : {';', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ' ';
}

void add_numbers(NumberRows& rows, std::string_view line, char separator, std::size_t number) {
  const std::string_view ends = separator == ' ' ? std::string_view(" \t") : std::string_view(&separator, 1);
  while (true) {
    const std::size_t end = line.find_first_of(ends);
    rows.add_number(trim(line.substr(0, end)), number, separator);
    if (end == std::string_view::npos) return;
    line = separator == ' ' ? trim(line.substr(end)) : line.substr(end + 1);
  }
}

}  // namespace

LabelledTable parse_csv_matrix(std::string_view text, const std::string& source) {
  const char separator = number_separator(text);
  NumberRowReader reader(text, source, separator);
  std::optional<CsvRow> row = reader.next();
  const bool has_ids = row && !is_number(row->cells.front()) && !lacks_diagonal(*row);
  std::vector<std::string> ids;
  if (has_ids) {
    const CsvRow header = std::move(*row);
    row = reader.next();
    check_header(header, row, source);
    ids = read_ids(header, source);
  }
  NumberRows rows(source, TableShape::square);
  for (std::size_t i = 0; row; ++i, row = reader.next()) {
    if (has_ids) check_row_id(*row, i, ids, source);
    for (std::size_t j = has_ids ? 1 : 0; j < row->cells.size(); ++j) {
      rows.add_number(row->cells[j], row->line, separator);
    }
    rows.end_row(row->line);
  }
  LabelledTable result{.numbers = rows.matrix(), .row_ids = ids, .column_ids = ids};
  if (has_ids && ids.size() != static_cast<std::size_t>(result.numbers.cols())) {
    throw InputError(
        fmt::format("{}: the header row has {}, but there {} of {}", source, count_text(std::ssize(ids), "id", "ids"),
                    result.numbers.rows() == 1 ? "is 1 row" : fmt::format("are {} rows", result.numbers.rows()),
                    count_text(result.numbers.cols(), "number", "numbers")));
  }
  return result;
}

LabelledTable parse_csv_table(std::string_view text, const std::string& source) {
  const char separator = number_separator(text);
  NumberRowReader reader(text, source, separator);
  std::optional<CsvRow> row = reader.next();
  std::optional<CsvRow> header;
  if (row && is_header(*row)) header = std::exchange(row, reader.next());
  if (row || header) check_separator(row ? *row : *header, source);
  const bool row_ids = (header && names_ids(header->cells.front())) || (row && !is_number(row->cells.front()));
  const std::ptrdiff_t first_column = row_ids ? 1 : 0;
  if (header) check_no_classes(*header, first_column, source);
  LabelledTable result;
  NumberRows rows(source, TableShape::any);
  for (; row; row = reader.next()) {
    if (row_ids) result.row_ids.push_back(row->cells.front());
    for (auto cell = row->cells.begin() + first_column; cell != row->cells.end(); ++cell) {
      rows.add_number(*cell, row->line, separator);
    }
    rows.end_row(row->line);
  }
  result.numbers = rows.matrix();
  check_ids(result.row_ids, source);
  if (!header) return result;
  result.column_ids.assign(header->cells.begin() + first_column, header->cells.end());
  if (result.column_ids.size() != static_cast<std::size_t>(result.numbers.cols())) {
    throw InputError(fmt::format("{}:{}: the header row has {} names, but the rows have {} numbers", source,
                                 header->line, result.column_ids.size(), result.numbers.cols()));
  }
  return result;
}

bool is_vector(std::string_view text) {
  std::size_t lines = 0;
  bool all_single = true;
  for (std::string_view line : split_lines(text)) {
    line = trim(line);
    if (line.empty() || line.starts_with('#')) continue;
    all_single = all_single && line.find_first_of(" \t,;") == std::string_view::npos;
    if (++lines == 2) return all_single;
  }
  return lines == 1;
}

DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source, TableShape shape) {
  NumberRows rows(source, shape);
  std::optional<char> separator;
  std::size_t number = 0;
  bool all_end_with_separator = false;
  for (std::string_view line : split_lines(text)) {
    ++number;
    line = trim(line);
    if (line.empty() || line.starts_with('#') || (number == 1 && line.starts_with("sep="))) continue;
    if (!separator) {
      separator = separator_of_line(line);
      all_end_with_separator = line.size() > 1 && line.ends_with(*separator);
    }
    if (all_end_with_separator && line.ends_with(*separator)) line.remove_suffix(1);
    add_numbers(rows, line, *separator, number);
    rows.end_row(number);
  }
  return rows.matrix();
}

}  // namespace shapegauge
