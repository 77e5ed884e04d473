// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace shapegauge {

/// Returns the number of distinct rows that a table loses by rounding to single precision: k different rows that become
/// equal count as k - 1. `numbers` holds the table row by row, without NaN.
std::size_t rows_merged_in_single_precision(std::span<const double> numbers, std::size_t columns);

}  // namespace shapegauge
