// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/words.h"

namespace shapegauge {

/// Begin and end of bold text on a terminal.
/// @{
inline constexpr std::string_view terminal_bold = "\x1b[1m";
inline constexpr std::string_view terminal_plain = "\x1b[0m";
/// @}

/// Emphasis of a cell: bold in Markdown and LaTeX, followed by a mark; ignored in CSV.
struct Emphasis {
  std::size_t row = 0;
  std::size_t column = 0;
  bool bold = false;
  std::string mark;
};

/// Formats a number with a number of decimals, avoiding "-0.00".
std::string decimal_text(double number, int decimals);

/// Table of text cells with formatted numbers. Every row has as many cells as the header.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows{};
  std::size_t text_columns =
      1;  ///< number of leading columns with words, aligned left; the others have numbers, aligned right
  std::vector<Emphasis> emphases{};
};

/// Makes the largest number of each numeric column bold, with ties by appearance, within each group of rows that have
/// the same words in the text columns from `first_key` on. Groups of one row have no bold cells. Text after the leading
/// number of a cell is ignored.
void embolden_best(TextTable& table, std::size_t first_key);

/// Formats a table as CSV (RFC 4180, LF).
std::string to_csv(const TextTable& table);
/// Formats a table for a terminal: aligned columns, separated by two blanks; bold cells by escape sequences if `bold`.
std::string to_plain_text(const TextTable& table, bool bold = false);
/// Escapes a text for one line of Markdown, where it then appears as it is.
std::string markdown_text(const std::string& text);
/// Formats a table as Markdown, aligned in the source as well.
std::string to_markdown(const TextTable& table);
/// Formats a table as a LaTeX tabular environment, which needs the package booktabs.
std::string to_latex(const TextTable& table);

/// Formats of tables; `table` is for a terminal.
enum class TableFormat { table, csv, markdown, latex };
template <>
inline constexpr std::array<std::string_view, 4> words_of<TableFormat>{"table", "csv", "markdown", "latex"};

/// Formats a table by one of the functions above. `bold` is for to_plain_text().
std::string table_text(const TextTable& table, TableFormat format, bool bold = false);

}  // namespace shapegauge
