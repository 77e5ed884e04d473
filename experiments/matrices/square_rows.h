#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Puts a square matrix together from the rows of a text file and refuses what does not fit, with file and line.
class SquareRows {
 public:
  /// `source` stands in front of error messages and must outlive this.
  explicit SquareRows(const std::string& source) : source_(&source) {}

  /// Adds the next number to the row that is being read. Throws InputError where the word is not a number.
  void add_number(std::string_view word, std::size_t line);

  /// Ends the row. Throws InputError where it is not as long as the first one, or has no numbers.
  void end_row(std::size_t line);

  /// The matrix. Throws InputError where there are no rows, or not as many as columns.
  [[nodiscard]] DistanceMatrix matrix() const;

 private:
  const std::string* source_;
  std::vector<double> numbers_;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t first_line_ = 0;
  std::size_t row_begin_ = 0;
};

}  // namespace shapegauge
