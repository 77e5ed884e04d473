#pragma once

#include <cstddef>
#include <string_view>

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// A measure: a name, what it means, and the function. It judges the answer to one query by a number from 0 to 1
/// (larger is better) for every list with at least one relevant model. Exactly one of the functions is there.
struct MeasureDefinition {
  std::string_view name;        ///< in tables and options; it ends in "@k" where there is a number of ranks to choose
  std::string_view title;       ///< spelled out
  std::string_view definition;  ///< h(i) is 1 where rank i is a hit, R the number of relevant models
  std::string_view source;
  std::string_view caveat;
  double (*value)(const RankedList&) = nullptr;
  double (*value_at)(const RankedList&, std::size_t k) = nullptr;
};

}  // namespace shapegauge
