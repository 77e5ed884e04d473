#pragma once

#include "shapegauge/experiments/datasets/dataset.h"

namespace shapegauge {

/// The layout "csv": a table with the columns id, path and class, in any order, named in its first row; paths are
/// relative to the root. Further columns are allowed. Throws InputError with the line: a table that is absent, empty or
/// lacks a column, a row of another length, an empty cell, an id that occurs twice.
Dataset find_csv_dataset(const DatasetLocation& location);

}  // namespace shapegauge
