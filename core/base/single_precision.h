#pragma once

#include <cstddef>
#include <span>

namespace shapegauge {

/// Returns the number of rows of a table that equal another row, from which they differ, when all numbers are rounded
/// to single precision; repeated rows count once, and one row of each group does not count. `numbers` are row by row
/// and not NaN.
std::size_t rows_merged_in_single_precision(std::span<const double> numbers, std::size_t columns);

}  // namespace shapegauge
