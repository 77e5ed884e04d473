#pragma once

#include "shapegauge/pages/report.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge::test_report {

/// What reports point to.
struct SampleReport {
  std::vector<DistanceMatrix> distances;
  std::vector<DistanceOverview> overviews;
  std::vector<Signatures> signatures;
  std::vector<std::vector<Evaluation>> evaluations;  ///< by method and protocol
  Report report;
};

/// A report of three methods, the third the first two side by side, under both protocols, on models of three classes of
/// unequal size, one of them a single model; with pictures, warnings and failures. All names are text that a page of
/// markup and scripts could trip over.
const SampleReport& hostile_report();

/// A report of one distance matrix and nothing else, not symmetric and with an infinite entry.
const SampleReport& plain_report();

/// A report of sixteen methods, some of long names: more than there are colours.
const SampleReport& crowded_report();

}  // namespace shapegauge::test_report
