// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "shapegauge/core/base/distance_rows.h"

namespace shapegauge {

/// Table of numbers with ids: distances from the row's model to the column's model, or one row of features per model.
struct LabelledTable {
  DistanceMatrix numbers;               ///< distances or features, one row per model
  std::vector<std::string> row_ids;     ///< ids of the models of the rows; empty if unknown
  std::vector<std::string> column_ids;  ///< ids of the models or features of the columns; empty if unknown
};

/// Matrix shape that a reader accepts: a square distance matrix, whose rows and columns have the same ids, or any table
/// of numbers.
enum class TableShape { square, any };

}  // namespace shapegauge
