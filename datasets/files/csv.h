// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Row of a table of separated values, with its line number for error messages.
struct CsvRow {
  std::vector<std::string> cells;
  std::size_t line = 0;  ///< line of the file on which the row begins, counted from 1
};

/// Maximum number of cells in one row of a CSV file.
inline constexpr std::size_t max_csv_cells = 1'000'000;

/// Reader of separated values (RFC 4180) row by row. Lines end with LF or CR LF, or with CR in a text without LF. A
/// quoted cell may contain separators, line ends and, doubled, quotation marks. Blanks around a cell are removed, and
/// so is the apostrophe in front of a formula (csv_cell()). A first line "sep=;", as Excel writes it, is skipped;
/// first_separator() and number_separator() return what it declares.
class CsvReader {
 public:
  /// Prepares to read `text`, which must outlive the reader. `source` prefixes error messages.
  CsvReader(std::string_view text, std::string source, char separator);

  /// Returns the next row that is not blank, or nothing at the end of the text. A blank row has only empty cells, none
  /// of them quoted. Throws InputError "<source>:<line>: ..." for an unclosed quotation mark, for text after a closing
  /// quotation mark, and for a row of more than max_csv_cells cells.
  std::optional<CsvRow> next();

 private:
  CsvRow take_row();
  void skip_blanks();
  [[nodiscard]] bool is_blank(char c) const;
  std::string_view take_to_cell_end();
  std::string take_quoted_cell();
  [[noreturn]] void fail(std::size_t line, const std::string& message) const;

  std::string_view rest_;
  std::string source_;
  char separator_;
  char line_end_;
  std::string cell_ends_;
  std::size_t line_ = 1;
  bool quoted_ = false;  ///< true if the current row has a quoted cell
};

/// Parses all rows of a comma-separated text, except blank rows. Throws InputError as CsvReader does.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& source);

/// Returns the separator of a table: the first of tab, semicolon and comma that occurs in the first non-blank line;
/// nothing if none does.
std::optional<char> first_separator(std::string_view text);

/// Parses a table of words, separated by first_separator() or, without one, by commas. Throws InputError as parse_csv()
/// does, for rows of different lengths, and for more than 10 million rows.
std::vector<CsvRow> parse_word_table(std::string_view text, const std::string& source);

/// Accepted names, in lower case, of the table column that contains the class of each model.
inline constexpr std::array<std::string_view, 3> class_column_names{"class", "label", "category"};

/// Accepted names, in lower case, of the table column that contains the subclass of each model.
inline constexpr std::array<std::string_view, 2> subclass_column_names{"subclass", "subcategory"};

/// Returns the index of the first column that has one of the lower-case `names`, ignoring case; nothing if none has.
std::optional<std::size_t> find_column(const CsvRow& header, std::span<const std::string_view> names);

/// Returns the index of the column named in class_column_names; nothing if there is none. Throws InputError for several
/// such columns.
std::optional<std::size_t> find_class_column(const CsvRow& header, const std::string& source);

/// Returns the separator of a table of numbers, with or without quoted names: a comma, unless the first line has tabs
/// or semicolons and no commas other than quoted or decimal ones (between digits).
char number_separator(std::string_view text);

/// Formats a cell that parse_csv() restores, quoted if necessary. A cell that a spreadsheet would take as a formula
/// ("=1+1") gets an apostrophe in front, which a spreadsheet does not show.
std::string csv_cell(std::string_view text);

/// Formats the cells as one line of CSV, ended by LF.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace shapegauge
