#pragma once

#include <string>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// A distance matrix and the models that its rows and columns stand for.
struct LabelledDistances {
  DistanceMatrix distances;
  std::vector<std::string> ids;  ///< of row and column i; empty where they are not known
};

/// A table of numbers: distances from the rows' models to the columns', or a row of features for each model.
struct LabelledTable {
  DistanceMatrix numbers;
  std::vector<std::string> row_ids;     ///< empty where they are not known
  std::vector<std::string> column_ids;  ///< so too
};

}  // namespace shapegauge
