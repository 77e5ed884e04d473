#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace shapegauge {

/// How a cell stands out: in bold in Markdown and LaTeX, and with a mark behind it (in CSV neither).
struct Emphasis {
  std::size_t row = 0;
  std::size_t column = 0;
  bool bold = false;
  std::string mark;
};

/// The number with so many decimals, without "-0.00".
std::string decimal_text(double number, int decimals);

/// A table of text cells, numbers already formatted. Every row has as many cells as the header.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t text_columns = 1;  ///< the first so many columns are words, aligned left; the others numbers, right
  std::vector<Emphasis> emphases{};
};

/// Makes the largest number of each column of numbers bold, all of them where several look the same, among the rows
/// that have the same words in the text columns from `first_key` on; where such a group is of one row nothing is bold.
/// Cells may begin with a number and go on.
void embolden_best(Table& table, std::size_t first_key);

/// The table as CSV (RFC 4180, LF).
std::string to_csv(const Table& table);
/// The table for a terminal: columns aligned, separated by two blanks.
std::string to_plain_text(const Table& table);
/// The table as a Markdown table, aligned in the source as well.
std::string to_markdown(const Table& table);
/// The table as a LaTeX tabular environment; it needs the package booktabs.
std::string to_latex(const Table& table);

}  // namespace shapegauge
