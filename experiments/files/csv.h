#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// The cells of one line of comma-separated values (RFC 4180, except that a quoted cell cannot go on over a line end).
/// A cell in quotation marks may contain commas and, doubled, quotation marks; blanks around a cell do not count. An
/// empty line is one empty cell. Throws InputError "<where>: ..." where quotation marks are not closed or something
/// follows them; `where` names the file and the line.
std::vector<std::string> split_csv_line(std::string_view line, const std::string& where);

/// One row of a table.
struct CsvRow {
  std::vector<std::string> cells;
  std::size_t line = 0;  ///< of the file, counted from 1
};

/// The rows of a text of comma-separated values, by split_csv_line; lines with nothing but blanks are passed over.
/// Throws InputError "<source>:<line>: ..." as it does.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& source);

/// The text as a cell that split_csv_line reads back: in quotation marks where it needs them. The text has no line end.
std::string csv_cell(std::string_view text);

/// The cells as one line, with its LF.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace shapegauge
