#include "shapegauge/experiments/text/table.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

#include "shapegauge/experiments/text/csv.h"

namespace shapegauge {

namespace {

using Row = std::vector<std::string>;

/// Letters, not bytes, of a UTF-8 text.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & '\xC0') != '\x80'; }));
}

std::vector<std::size_t> column_widths(const Table& table) {
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

Table with_cells(Table table, const std::function<std::string(const std::string&)>& change) {
  std::ranges::transform(table.header, table.header.begin(), change);
  for (Row& row : table.rows) std::ranges::transform(row, row.begin(), change);
  return table;
}

std::string markdown_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|' || c == '\\') escaped += '\\';
    escaped += c == '\n' || c == '\r' ? ' ' : c;
  }
  return escaped;
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

}  // namespace

std::string to_csv(const Table& table) {
  std::string text = csv_line(table.header);
  for (const Row& row : table.rows) text += csv_line(row);
  return text;
}

std::string to_plain_text(const Table& table) {
  const std::vector<std::size_t> widths = column_widths(table);
  std::string text = line(table.header, widths, table.text_columns, "  ") + "\n";
  for (const Row& row : table.rows) text += line(row, widths, table.text_columns, "  ") + "\n";
  return text;
}

std::string to_markdown(const Table& table) {
  const Table escaped = with_cells(table, markdown_cell);
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

std::string to_latex(const Table& table) {
  const Table escaped = with_cells(table, latex_cell);
  const std::vector<std::size_t> widths = column_widths(escaped);
  const std::string columns =
      std::string(table.text_columns, 'l') + std::string(widths.size() - table.text_columns, 'r');
  std::string text = fmt::format("\\begin{{tabular}}{{{}}}\n\\hline\n", columns);
  text += line(escaped.header, widths, table.text_columns, " & ") + " \\\\\n\\hline\n";
  for (const Row& row : escaped.rows) text += line(row, widths, table.text_columns, " & ") + " \\\\\n";
  return text + "\\hline\n\\end{tabular}\n";
}

}  // namespace shapegauge
