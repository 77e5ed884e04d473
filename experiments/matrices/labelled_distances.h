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

}  // namespace shapegauge
