#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace shapegauge {

/// A table of text cells, numbers already formatted. Every row has as many cells as the header.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t text_columns = 1;  ///< the first so many columns are words, aligned left; the others numbers, right
};

/// The table as CSV (RFC 4180, LF).
std::string to_csv(const Table& table);
/// The table for a terminal: columns aligned, separated by two blanks.
std::string to_plain_text(const Table& table);
/// The table as a Markdown table, aligned in the source as well.
std::string to_markdown(const Table& table);
/// The table as a LaTeX tabular environment that needs no package.
std::string to_latex(const Table& table);

}  // namespace shapegauge
