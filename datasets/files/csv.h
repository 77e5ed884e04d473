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
  std::vector<std::string> cells;  ///< texts of the cells, without quotation marks
  std::size_t line = 0;            ///< line of the file on which the row begins, counted from 1
};

/// Maximum number of cells in one row of a CSV file.
inline constexpr std::size_t max_csv_cells = 1'000'000;

/// Reader of separated values (RFC 4180) row by row. Lines end with LF or CR LF, or with CR in a text without LF. A
/// quoted cell may contain separators, line ends and, doubled, quotation marks. Blanks around a cell are removed, and
/// so is the apostrophe in front of a formula (csv_cell()). A first line "sep=;", as Excel writes it, is skipped;
/// first_separator() and number_separator() return what it declares.
class CsvReader {
 public:
  /// Prepares to read `text`, which must outlive the reader. `source` prefixes error messages; `separator` separates
  /// cells.
  CsvReader(std::string_view text, std::string source, char separator);

  /// Returns the next row that is not blank, or nothing at the end of the text. A blank row has only empty cells, none
  /// of them quoted. Throws InputError "<source>:<line>: ..." for an unclosed quotation mark, for text after a closing
  /// quotation mark, and for a row of more than max_csv_cells cells.
  std::optional<CsvRow> next();

 private:
  CsvRow read_row();                          ///< reads the next row, blank or not
  void skip_blanks();                         ///< skips blanks and tabs that are not separators
  [[nodiscard]] bool is_blank(char c) const;  ///< true for a blank or tab that is not the separator
  std::string_view read_to_cell_end();        ///< reads up to the next separator or line end
  std::string read_quoted_cell();             ///< reads a cell in quotation marks
  [[noreturn]] void fail(std::size_t line, const std::string& message) const;  ///< throws InputError at a line

  std::string_view rest_;  ///< text that is not yet read
  std::string source_;     ///< name of the file, for messages
  char separator_;         ///< separator of cells
  char line_end_;          ///< LF, or CR in a text without LF
  std::string cell_ends_;  ///< characters that end an unquoted cell: separator and line end
  std::size_t line_ = 1;   ///< number of the line being read, from 1
  bool quoted_ = false;    ///< true if the row being read has a quoted cell
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

/// Returns the index of the first cell of a table's first row that is one of the lower-case `names`, ignoring case;
/// nothing if none is.
std::optional<std::size_t> find_column(const CsvRow& header, std::span<const std::string_view> names);

/// Returns the index of the column whose name is in class_column_names; nothing if there is none. Throws InputError,
/// with `source`, for several such columns.
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
