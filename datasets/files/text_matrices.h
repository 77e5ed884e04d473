#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

/// Matrices and tables of numbers as text.
namespace shapegauge {

/// A distance matrix and the models that its rows and columns stand for.
struct LabelledDistances {
  DistanceMatrix distances;
  std::vector<std::string> ids;  ///< of row and column i; empty where they are not known
};

/// A table of numbers: distances from the rows' models to the columns', or a row of features for each model.
struct LabelledTable {
  DistanceMatrix numbers;
  std::vector<std::string> row_ids;     ///< empty where they are not known
  std::vector<std::string> column_ids;  ///< so too
};

/// What a reader takes: the square matrix of a distance, or any table of numbers.
enum class TableShape { square, any };

/// Reads a square matrix of numbers separated by commas, semicolons or tabs (number_separator()). With ids: a header
/// row (a first cell that is not a number, then the ids of the columns) and an id in front of each row, the same ids in
/// the same order. Where the very first cell is a number the file has no ids. Cells may be quoted. Throws InputError:
/// absent or unreadable file, something that is not a number, a row of another length, not as many rows as columns, an
/// id that is empty or occurs twice, ids of rows and columns that differ.
LabelledDistances read_csv_matrix(const std::filesystem::path& path);

/// The same for the text of a file; `source` stands in front of messages.
LabelledDistances parse_csv_matrix(std::string_view text, const std::string& source);

/// Reads any table of numbers, separated as above, with rows of equal length, with or without ids. The first row is a
/// header where its first cell is no number, unless all its other cells are numbers and that cell is neither empty nor
/// "id". The first column holds the ids of the rows where the header begins with an empty cell or "id", or where the
/// first cell of the first row of numbers is no number. Throws InputError as read_csv_matrix.
LabelledTable parse_csv_table(std::string_view text, const std::string& source);

/// Reads a square matrix of numbers between blanks, one row a line, as numpy.savetxt writes it; where its first row has
/// semicolons or, failing that, commas, those separate the numbers. Empty lines and lines that begin with `#` are
/// passed over; `inf` is a number. Throws InputError: absent or unreadable file, something that is not a number, a row
/// of another length, not as many rows as columns.
DistanceMatrix read_text_matrix(const std::filesystem::path& path);

/// The same for the text of a file; `source` stands in front of messages. With TableShape::any the rows need only be of
/// equal length.
DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source,
                                 TableShape shape = TableShape::square);

}  // namespace shapegauge
