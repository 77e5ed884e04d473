// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/table.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <optional>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/csv.h"

namespace shapegauge {

namespace {

using Row = std::vector<std::string>;

/// Counts the letters, not bytes, of a UTF-8 text. Escape sequences are those of bold cells.
std::size_t letters(const std::string& text) {
  const auto all = std::ranges::count_if(text, [](char c) { return (c & '\xC0') != '\x80'; });
  return static_cast<std::size_t>(all - std::ranges::count(text, '\x1b') * std::ssize(terminal_bold));
}

std::vector<std::size_t> column_widths(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& cell : table.header) widths.push_back(letters(cell));
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters(row[i]));
  }
  return widths;
}

std::string padded(const std::string& cell, std::size_t width, bool left) {
  const std::string blanks(width - std::min(width, letters(cell)), ' ');
  return left ? cell + blanks : blanks + cell;
}

std::string line(const Row& row, const std::vector<std::size_t>& widths, std::size_t text_columns,
                 std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) text += separator;
    text += padded(row[i], widths[i], i < text_columns);
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

TextTable with_cells(TextTable table, const std::function<std::string(const std::string&)>& change) {
  std::ranges::transform(table.header, table.header.begin(), change);
  for (Row& row : table.rows) std::ranges::transform(row, row.begin(), change);
  return table;
}

// Formats a cell for one line of a terminal.
std::string plain_cell(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return printable(text);
}

/// Returns true for a digit or a letter; those beyond ASCII count as letters.
bool is_word_character(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & '\x80') != 0;
}

/// Returns true for a character between two others that Markdown would not print as it is.
bool is_markup(char before, char c, char after) {
  switch (c) {
    case '_':  // within a word it is literal
      return !(is_word_character(before) && is_word_character(after));
    case '<':
    case '&':
      return is_word_character(after) || after == '/' || after == '!' || after == '?' || after == '#';
    case '(':  // of a link
      return before == ']';
    default:
      return std::string_view("\\`*|~").find(c) != std::string_view::npos;
  }
}

std::string latex_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '\\':
        escaped += "\\textbackslash{}";
        break;
      case '~':
        escaped += "\\textasciitilde{}";
        break;
      case '^':
        escaped += "\\textasciicircum{}";
        break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        escaped += '\\';
        escaped += c;
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

// Formats the emphases of a cell.
using Emphasise = std::function<std::string(const std::string& cell, const Emphasis& emphasis)>;

TextTable with_emphases(TextTable table, const Emphasise& emphasise) {
  for (const Emphasis& emphasis : table.emphases) {
    std::string& cell = table.rows[emphasis.row][emphasis.column];
    cell = emphasise(cell, emphasis);
  }
  return table;
}

std::string with_plain_mark(const std::string& cell, const Emphasis& emphasis) {
  return emphasis.mark.empty() ? cell : cell + " " + emphasis.mark;
}

std::string with_bold_text(const std::string& cell, const Emphasis& emphasis) {
  const std::string text = with_plain_mark(cell, emphasis);
  return emphasis.bold ? fmt::format("{}{}{}", terminal_bold, text, terminal_plain) : text;
}

std::string with_markdown(const std::string& cell, const Emphasis& emphasis) {
  const std::string mark = emphasis.mark.empty() ? "" : fmt::format(" <sup>{}</sup>", emphasis.mark);
  return (emphasis.bold ? fmt::format("**{}**", cell) : cell) + mark;
}

std::string with_latex(const std::string& cell, const Emphasis& emphasis) {
  const std::string mark = emphasis.mark.empty() ? "" : fmt::format("\\textsuperscript{{{}}}", emphasis.mark);
  return (emphasis.bold ? fmt::format("\\textbf{{{}}}", cell) : cell) + mark;
}

// Returns the number at the beginning of the cell.
std::optional<double> leading_number(const std::string& cell) { return parse_number(cell.substr(0, cell.find(' '))); }

// Emphasises the best of some rows in one column.
void embolden_best_of(TextTable& table, const std::vector<std::size_t>& rows, std::size_t column) {
  std::optional<double> best;
  for (const std::size_t row : rows) {
    const auto number = leading_number(table.rows[row][column]);
    if (number && (!best || *number > *best)) best = number;
  }
  for (const std::size_t row : rows) {
    if (!best || leading_number(table.rows[row][column]) != best) continue;
    const auto same_cell = [&](const Emphasis& e) { return e.row == row && e.column == column; };
    const auto known = std::ranges::find_if(table.emphases, same_cell);
    if (known != table.emphases.end()) {
      known->bold = true;
    } else {
      table.emphases.push_back({.row = row, .column = column, .bold = true, .mark = {}});
    }
  }
}

}  // namespace

std::string decimal_text(double number, int decimals) {
  std::string text = fmt::format("{:.{}f}", number, decimals);
  if (text.starts_with("-0") && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

void embolden_best(TextTable& table, std::size_t first_key) {
  std::map<Row, std::vector<std::size_t>> groups;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto cells = table.rows[row].begin();
    groups[Row(cells + static_cast<std::ptrdiff_t>(first_key), cells + static_cast<std::ptrdiff_t>(table.text_columns))]
        .push_back(row);
  }
  for (const auto& [key, rows] : groups) {
    if (rows.size() < 2) continue;
    for (std::size_t column = table.text_columns; column < table.header.size(); ++column) {
      embolden_best_of(table, rows, column);
    }
  }
}

std::string to_csv(const TextTable& table) {
  std::string text = csv_line(table.header);
  for (const Row& row : table.rows) text += csv_line(row);
  return text;
}

std::string to_plain_text(const TextTable& table, bool bold) {
  const TextTable marked = with_emphases(with_cells(table, plain_cell), bold ? with_bold_text : with_plain_mark);
  const std::vector<std::size_t> widths = column_widths(marked);
  std::string text = line(marked.header, widths, marked.text_columns, "  ") + "\n";
  for (const Row& row : marked.rows) text += line(row, widths, marked.text_columns, "  ") + "\n";
  return text;
}

std::string markdown_text(const std::string& text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_markup(i > 0 ? text[i - 1] : ' ', text[i], i + 1 < text.size() ? text[i + 1] : ' ')) escaped += '\\';
    escaped += text[i] == '\n' || text[i] == '\r' ? ' ' : text[i];
  }
  return escaped;
}

std::string to_markdown(const TextTable& table) {
  const TextTable escaped = with_emphases(with_cells(table, markdown_text), with_markdown);
  std::vector<std::size_t> widths = column_widths(escaped);
  std::string rule = "|";
  for (std::size_t i = 0; i < widths.size(); ++i) {
    widths[i] = std::max<std::size_t>(widths[i], 3);
    rule += i < table.text_columns ? fmt::format(" {:-<{}} |", "", widths[i])
                                   : fmt::format(" {:->{}}: |", "", widths[i] - 1);
  }
  const auto framed = [&](const Row& row) {
    std::string text = "|";
    for (std::size_t i = 0; i < row.size(); ++i)
      text += fmt::format(" {} |", padded(row[i], widths[i], i < table.text_columns));
    return text + "\n";
  };
  std::string text = framed(escaped.header) + rule + "\n";
  for (const Row& row : escaped.rows) text += framed(row);
  return text;
}

std::string to_latex(const TextTable& table) {
  const TextTable escaped = with_emphases(with_cells(table, latex_cell), with_latex);
  const std::vector<std::size_t> widths = column_widths(escaped);
  const std::string columns =
      std::string(table.text_columns, 'l') + std::string(widths.size() - table.text_columns, 'r');
  std::string text = fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n", columns);
  text += line(escaped.header, widths, table.text_columns, " & ") + " \\\\\n\\midrule\n";
  for (const Row& row : escaped.rows) text += line(row, widths, table.text_columns, " & ") + " \\\\\n";
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string table_text(const TextTable& table, TableFormat format, bool bold) {
  switch (format) {
    case TableFormat::csv:
      return to_csv(table);
    case TableFormat::markdown:
      return to_markdown(table);
    case TableFormat::latex:
      return to_latex(table);
    case TableFormat::table:
      break;
  }
  return to_plain_text(table, bold);
}

}  // namespace shapegauge
