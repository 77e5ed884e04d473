#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// One row of a table.
struct CsvRow {
  std::vector<std::string> cells;
  std::size_t line = 0;  ///< where it begins in the file, counted from 1
};

/// The rows of a text of separated values (RFC 4180). A cell in quotation marks may contain separators, line ends and,
/// doubled, quotation marks; blanks around a cell do not count. Rows with nothing but blanks are passed over. Throws
/// InputError "<source>:<line>: ..." where quotation marks are not closed or something follows them.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& source, char separator = ',');

/// The separator of a table: the first of tab, semicolon and comma that occurs in the first line that is not blank;
/// nothing where none does.
std::optional<char> first_separator(std::string_view text);

/// The rows of a table of words with first_separator(), else a comma, between cells. Throws InputError as parse_csv,
/// and for a row of another length than the first.
std::vector<CsvRow> parse_word_table(std::string_view text, const std::string& source);

/// Names of the column that holds the class of each model, in the order of preference.
inline constexpr std::array<std::string_view, 3> class_column_names{"class", "label", "category"};

/// Position of the first column with one of these lower-case names, in any case; nothing where there is none.
std::optional<std::size_t> find_column(const CsvRow& header, std::span<const std::string_view> names);

/// The separator of a table of numbers, with or without names in quotation marks: a comma, unless the first line has
/// tabs or semicolons but no other commas than those in quotation marks and decimal ones (between digits).
char number_separator(std::string_view text);

/// The text as a cell that parse_csv reads back: in quotation marks where it needs them.
std::string csv_cell(std::string_view text);

/// The cells as one line, with its LF.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace shapegauge
