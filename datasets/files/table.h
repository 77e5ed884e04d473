// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/words.h"

namespace shapegauge {

/// Escape sequences that begin and end bold text on a terminal.
/// @{
inline constexpr std::string_view terminal_bold = "\x1b[1m";   ///< begins bold text
inline constexpr std::string_view terminal_plain = "\x1b[0m";  ///< ends bold text
/// @}

/// Emphasis of a table cell: bold text, a mark after the text, or both; ignored in CSV.
struct Emphasis {
  std::size_t row = 0;     ///< index of the cell's row in TextTable::rows
  std::size_t column = 0;  ///< index of the cell's column in TextTable::header
  bool bold = false;       ///< true for bold text
  std::string mark;        ///< text that follows the cell's text; empty for none
};

/// Formats a number with `decimals` decimal places, but never as "-0.00".
std::string decimal_text(double number, int decimals);

/// Table of text cells with formatted numbers. Every row has as many cells as the header.
struct TextTable {
  std::vector<std::string> header;               ///< titles of the columns
  std::vector<std::vector<std::string>> rows{};  ///< cells, row by row
  std::size_t text_columns =
      1;  ///< number of leading text columns, aligned left; the further columns have numbers, aligned right
  std::vector<Emphasis> emphases{};  ///< cells with bold text or a mark
};

/// Makes the largest number of each numeric column bold within each group of rows. Rows of a group have the same words
/// in the text columns from index `first_key` on. Numbers that are printed equally are all bold. Groups of one row have
/// no bold cells. Text after the leading number of a cell is ignored.
void embolden_best(TextTable& table, std::size_t first_key);

/// Formats a table as CSV (RFC 4180, LF).
std::string to_csv(const TextTable& table);
/// Formats a table for a terminal: aligned columns, separated by two blanks; bold cells by escape sequences if `bold`.
std::string to_plain_text(const TextTable& table, bool bold = false);
/// Escapes a text such that Markdown renders it literally on one line.
std::string markdown_text(const std::string& text);
/// Formats a table as Markdown, aligned in the source as well.
std::string to_markdown(const TextTable& table);
/// Formats a table as a LaTeX tabular environment, which needs the package booktabs.
std::string to_latex(const TextTable& table);

/// Output format of a table; `table` is plain text for a terminal, see to_plain_text().
enum class TableFormat { table, csv, markdown, latex };
template <>
inline constexpr std::array<std::string_view, 4> words_of<TableFormat>{"table", "csv", "markdown", "latex"};

/// Formats a table by to_plain_text(), to_csv(), to_markdown() or to_latex(). Only to_plain_text() uses `bold`.
std::string table_text(const TextTable& table, TableFormat format, bool bold = false);

}  // namespace shapegauge
