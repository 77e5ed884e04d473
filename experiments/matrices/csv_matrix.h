#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/experiments/matrices/labelled_distances.h"

namespace shapegauge {

/// Reads a square matrix of comma-separated numbers. With ids: a header row (a first cell that is not a number, then
/// the ids of the columns) and an id in front of each row, the same ids in the same order. Where the very first cell is
/// a number the file has no ids. Cells may be quoted. Throws InputError: absent or unreadable file, something that is
/// not a number, a row of another length, not as many rows as columns, an id that is empty or occurs twice, ids of rows
/// and columns that differ.
LabelledDistances read_csv_matrix(const std::filesystem::path& path);

/// The same for the text of a file; `source` stands in front of messages.
LabelledDistances parse_csv_matrix(std::string_view text, const std::string& source);

/// Reads any table of comma-separated numbers with rows of equal length, with or without ids. The first row is a header
/// where its first cell is no number, unless all its other cells are numbers and that cell is neither empty nor "id".
/// The first column holds the ids of the rows where the header begins with an empty cell or "id", or where the first
/// cell of the first row of numbers is no number. Throws InputError as read_csv_matrix.
LabelledTable parse_csv_table(std::string_view text, const std::string& source);

/// Writes a matrix as CSV, with ids where it has them; every distance with as many digits as it takes to read back the
/// same number. Throws InputError where the file cannot be written or an id is empty, occurs twice or contains a line
/// break, and std::invalid_argument where there are ids but not one for each row.
void write_csv_matrix(const std::filesystem::path& path, const LabelledDistances& matrix);

}  // namespace shapegauge
