#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

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

}  // namespace shapegauge
