#pragma once

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// NN, nearest neighbour: 1 where the nearest model other than the query is of the query's class, else 0.
///
/// Source: Shilane, Min, Kazhdan, Funkhouser, "The Princeton Shape Benchmark", SMI 2004, section 4.
/// Caveat: one model decides, so an exact duplicate of the query in the data set makes it 1. Where several models are
/// equally near, the order of the models decides.
double nearest_neighbour(const RankedList& list);

}  // namespace shapegauge
