#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Row of a table.
struct CsvRow {
  std::vector<std::string> cells;
  std::size_t line = 0;  ///< line of the file on which the row begins, counted from 1
};

/// Parses separated values (RFC 4180). A quoted cell may contain separators, line ends and, doubled, quotation marks.
/// Blanks around a cell are removed, and blank rows skipped. Throws InputError "<source>:<line>: ..." for an unclosed
/// quotation mark and for text after a closing one.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& source, char separator = ',');

/// Returns the separator of a table: the first of tab, semicolon and comma that occurs in the first non-blank line;
/// nothing if none does.
std::optional<char> first_separator(std::string_view text);

/// Parses a table of words, separated by first_separator() or, without one, by commas. Throws InputError as parse_csv()
/// does, and for rows of different lengths.
std::vector<CsvRow> parse_word_table(std::string_view text, const std::string& source);

/// Names of the column with the class of each model, in lower case.
inline constexpr std::array<std::string_view, 3> class_column_names{"class", "label", "category"};

/// Names of the column with the subclass of a model, in lower case.
inline constexpr std::array<std::string_view, 2> subclass_column_names{"subclass", "subcategory"};

/// Returns the index of the first column with one of these lower-case names, ignoring case; nothing if there is none.
std::optional<std::size_t> find_column(const CsvRow& header, std::span<const std::string_view> names);

/// Returns the index of the column named in class_column_names; nothing if there is none. Throws InputError for
/// several.
std::optional<std::size_t> find_class_column(const CsvRow& header, const std::string& source);

/// Returns the separator of a table of numbers, with or without quoted names: a comma, unless the first line has tabs
/// or semicolons and no commas other than quoted or decimal ones (between digits).
char number_separator(std::string_view text);

/// Formats a cell that parse_csv() restores, quoted if necessary.
std::string csv_cell(std::string_view text);

/// Formats the cells as one line with its LF.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace shapegauge
