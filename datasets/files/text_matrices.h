#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

/// Matrices and tables of numbers as text.
namespace shapegauge {

/// Distance matrix with the ids of its models.
struct LabelledDistances {
  DistanceMatrix distances;
  std::vector<std::string> ids;  ///< of row and column i; empty if unknown
};

/// Table of numbers: distances from the rows' models to the columns', or one row of features a model.
struct LabelledTable {
  DistanceMatrix numbers;
  std::vector<std::string> row_ids;     ///< empty if unknown
  std::vector<std::string> column_ids;  ///< empty if unknown
};

/// Shape accepted by a reader: a square distance matrix, or any table of numbers.
enum class TableShape { square, any };

/// Reads a square matrix of numbers separated by commas, semicolons or tabs (number_separator()). With ids, the file
/// has a header row (a first cell that is not a number, then the ids of columns) and an id at the beginning of each
/// row, in the same order. If the very first cell is a number, the file has no ids. Cells may be quoted. Throws
/// InputError for an absent or unreadable file, an invalid number, a row of another length, different numbers of rows
/// and columns, an id that is empty or repeated, and different ids of rows and columns.
LabelledDistances read_csv_matrix(const std::filesystem::path& path);

/// Parses such a matrix from text; `source` prefixes error messages.
LabelledDistances parse_csv_matrix(std::string_view text, const std::string& source);

/// Parses a table of numbers of any shape with the same separators, with or without ids. The first row is a header if
/// its first cell is not a number, unless there are other cells, all of them numbers, and the first is neither empty
/// nor "id". The first column has the ids of rows if the header begins with an empty cell or "id", or if the first cell
/// of the first row of numbers is not a number. Throws InputError as read_csv_matrix() does.
LabelledTable parse_csv_table(std::string_view text, const std::string& source);

/// Reads a square matrix of numbers separated by blanks, one row a line, as numpy.savetxt writes it. If the first row
/// has semicolons or, failing that, commas, these are the separators. Skips empty lines and lines that begin with `#`;
/// accepts `inf`. Throws InputError for an absent or unreadable file, an invalid number, a row of another length, and
/// different numbers of rows and columns.
DistanceMatrix read_text_matrix(const std::filesystem::path& path);

/// Parses such a matrix from text; `source` prefixes error messages. With TableShape::any, rows only need equal
/// lengths.
DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source,
                                 TableShape shape = TableShape::square);

}  // namespace shapegauge
