// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/pages/report.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge::test_report {

/// Data that reports refer to.
struct SampleReport {
  std::vector<DistanceMatrix> distances;
  std::vector<DistanceOverview> overviews;
  std::vector<Signatures> signatures;
  std::vector<std::vector<Evaluation>> evaluations;  ///< by method and protocol
  Report report;
};

/// Report of three methods, the third a concatenation of the first two, under both protocols, on models of three
/// classes of unequal size, one of them a single model; with pictures, warnings and failures. All names need escaping
/// in markup and scripts.
const SampleReport& hostile_report();

/// Report of a single distance matrix, asymmetric and with an infinite entry.
const SampleReport& plain_report();

/// Report of sixteen methods, more than colours, some with long names.
const SampleReport& crowded_report();

}  // namespace shapegauge::test_report
