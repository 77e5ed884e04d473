// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "shapegauge/core/base/distance_rows.h"

namespace shapegauge {

/// Table of numbers: distances from the rows' models to the columns', or one row of features per model.
struct LabelledTable {
  DistanceMatrix numbers;
  std::vector<std::string> row_ids;     ///< empty if unknown
  std::vector<std::string> column_ids;  ///< empty if unknown
};

/// Shape that a reader accepts: a square distance matrix, whose rows and columns have the same ids, or any table of
/// numbers.
enum class TableShape { square, any };

}  // namespace shapegauge
