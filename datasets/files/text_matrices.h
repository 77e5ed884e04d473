// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "shapegauge/datasets/files/labelled_table.h"

/// Matrices and tables of numbers as text.
namespace shapegauge {

/// Parses a square matrix of numbers separated by commas, semicolons or tabs (number_separator()); `source` prefixes
/// error messages. With ids, the text has a header row (a first cell that is not a number, then the ids of columns) and
/// an id at the beginning of each row, in the same order. If the very first cell is a number, there are no ids. Cells
/// may be quoted. Entries on the diagonal may be missing (empty, NA, nan, null, -) and are then 0; all rows may end
/// with a separator. Throws InputError for an invalid number, an integer that double would round, a row of another
/// length, different numbers of rows and columns, an id that is empty or repeated, and different ids of rows and
/// columns.
LabelledTable parse_csv_matrix(std::string_view text, const std::string& source);

/// Parses a table of numbers of any shape, separated by commas, semicolons or tabs, with or without ids. The first row
/// is a header if its first cell is not a number. Exception: if further cells exist and all are numbers, the first cell
/// is an id unless it is empty or "id". The first column has the ids of rows if the header begins with an empty cell or
/// "id", or if the first cell of the first row of numbers is not a number. Throws InputError as parse_csv_matrix()
/// does.
LabelledTable parse_csv_table(std::string_view text, const std::string& source);

/// Returns true if the text is one line of numbers, or has one number in each of its first two lines.
bool is_vector(std::string_view text);

/// Parses numbers separated by blanks, one row per line, as numpy.savetxt writes them; `source` prefixes error
/// messages. If the first row has semicolons or, failing that, commas, these are the separators. Skips empty lines and
/// lines that begin with `#`; accepts `inf`. Throws InputError for an invalid number, a row of another length, and a
/// matrix of another shape.
DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source, TableShape shape);

}  // namespace shapegauge
