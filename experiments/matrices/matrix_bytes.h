#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

#include "shapegauge/core/io/byte_scanner.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// The matrix of the given size whose entries lie one after the other in the bytes, row by row or column by column.
/// There are exactly rows * columns * sizeof(Number) bytes.
template <typename Number>
DistanceMatrix matrix_of_bytes(std::string_view bytes, Eigen::Index rows, Eigen::Index columns, std::endian order,
                               bool column_by_column) {
  DistanceMatrix matrix(column_by_column ? columns : rows, column_by_column ? rows : columns);
  ByteScanner scanner(bytes, order);
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    Number value = 0;
    scanner.read(value);
    matrix.data()[i] = static_cast<double>(value);
  }
  if (column_by_column) matrix.transposeInPlace();
  return matrix;
}

/// Appends the number's bytes, little-endian.
template <typename Number>
void append_number(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

}  // namespace shapegauge
