#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

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

/// Puts a matrix together from the rows of a text file and refuses what does not fit, with file and line.
class NumberRows {
 public:
  /// `source` stands in front of error messages and must outlive this.
  NumberRows(const std::string& source, TableShape shape) : source_(&source), shape_(shape) {}

  /// Adds the next number to the row that is being read. Throws InputError where the word is not a number.
  void add_number(std::string_view word, std::size_t line);

  /// Ends the row. Throws InputError where it is not as long as the first one, or has no numbers.
  void end_row(std::size_t line);

  /// The matrix. Throws InputError where there are no rows, or, where it must be square, not as many as columns.
  [[nodiscard]] DistanceMatrix matrix() const;

 private:
  const std::string* source_;
  TableShape shape_;
  std::vector<double> numbers_;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t first_line_ = 0;
  std::size_t row_begin_ = 0;
};

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

/// Reads the Princeton Shape Benchmark's `.matrix`: N x N float32, little-endian, row by row, no header. N follows from
/// the size of the file. Throws InputError: absent, empty or unreadable file, a size that is not 4 N^2 bytes (with a
/// hint where it looks like float64).
DistanceMatrix read_psb_matrix(const std::filesystem::path& path);

/// The same for the bytes of a file; `source` stands in front of messages.
DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source);

/// Writes that format; distances are rounded to float32. Throws InputError where the file cannot be written or a finite
/// distance is beyond float32.
void write_psb_matrix(const std::filesystem::path& path, const DistanceMatrix& matrix);

/// Reads a square matrix of numbers between blanks, one row a line, as numpy.savetxt writes it. Empty lines and lines
/// that begin with `#` are passed over; `inf` is a number. Throws InputError: absent or unreadable file, something that
/// is not a number, a row of another length, not as many rows as columns.
DistanceMatrix read_text_matrix(const std::filesystem::path& path);

/// The same for the text of a file; `source` stands in front of messages. With TableShape::any the rows need only be of
/// equal length.
DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source,
                                 TableShape shape = TableShape::square);

/// Reads a square distance matrix in the format that the name's extension tells (any case): `.matrix` (Princeton Shape
/// Benchmark), `.npy` (NumPy), `.csv`, `.txt` or `.dat` (numbers between white space). Only CSV carries ids. Distances
/// may be infinite. Throws InputError: absent or unreadable file, another extension, anything that the reader of the
/// format refuses, a distance that is NaN.
LabelledDistances read_distance_matrix(const std::filesystem::path& path);

/// Reads any table of numbers in the same way: distances between two sets of models, or features. The ids of rows and
/// columns come with CSV (csv_matrix.h). Throws InputError as read_distance_matrix, but for the shape.
LabelledTable read_number_table(const std::filesystem::path& path);

}  // namespace shapegauge
