// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace shapegauge {

/// Counts the distinct rows of a table that become equal when rounded to single precision. One row of each group of
/// equal ones is not counted. `numbers` are row by row and not NaN.
std::size_t rows_merged_in_single_precision(std::span<const double> numbers, std::size_t columns);

}  // namespace shapegauge
