#pragma once

#include <span>
#include <string_view>

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// A measure with the name that tables show. It judges the answer to one query by a number from 0 to 1 (finite, larger
/// is better), for every list with at least one hit that is not the query itself.
struct Measure {
  std::string_view name;
  double (*value)(const RankedList&);
};

/// All measures, in the order of the tables' columns. A new one is one file in this folder and one line in
/// registry.cpp.
std::span<const Measure> measures();

}  // namespace shapegauge
