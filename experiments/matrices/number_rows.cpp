#include "shapegauge/experiments/matrices/number_rows.h"

#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/text/parse_number.h"
#include "shapegauge/experiments/text/quoted_word.h"

namespace shapegauge {

void NumberRows::add_number(std::string_view word, std::size_t line) {
  const auto number = parse_number(word);
  if (!number) {
    throw InputError(fmt::format("{}:{}: {} is not a number (number {} of the row)", *source_, line, quoted_word(word),
                                 numbers_.size() - row_begin_ + 1));
  }
  numbers_.push_back(*number);
}

void NumberRows::end_row(std::size_t line) {
  const std::size_t length = numbers_.size() - row_begin_;
  if (length == 0) throw InputError(fmt::format("{}:{}: the row has no numbers", *source_, line));
  if (rows_ == 0) {
    columns_ = length;
    first_line_ = line;
  }
  if (length != columns_) {
    throw InputError(fmt::format("{}:{}: the row has {} numbers, but the one in line {} has {}", *source_, line, length,
                                 first_line_, columns_));
  }
  if (shape_ == TableShape::square && rows_ == columns_) {
    throw InputError(fmt::format("{}:{}: a distance matrix is square, but this is row {} and rows have {} numbers",
                                 *source_, line, rows_ + 1, columns_));
  }
  ++rows_;
  row_begin_ = numbers_.size();
}

DistanceMatrix NumberRows::matrix() const {
  if (rows_ == 0) throw InputError(fmt::format("{}: the file has no numbers", *source_));
  if (shape_ == TableShape::square && rows_ != columns_) {
    throw InputError(
        fmt::format("{}: a distance matrix is square, but the file has {} rows of {} numbers; it may be "
                    "cut off",
                    *source_, rows_, columns_));
  }
  return Eigen::Map<const DistanceMatrix>(numbers_.data(), static_cast<Eigen::Index>(rows_),
                                          static_cast<Eigen::Index>(columns_));
}

}  // namespace shapegauge
