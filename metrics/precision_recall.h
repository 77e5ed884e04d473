#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapegauge/metrics/protocol.h"
#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// Precision at fixed levels of recall, averaged over queries.
struct PrecisionRecallCurve {
  std::vector<double> recall;
  std::vector<double> precision;
};

/// The levels of recall at which a protocol draws its curve: psb 0.05, 0.10, ... 1.0; paper 0, 0.1, ... 1.0.
std::vector<double> recall_levels(Protocol protocol);

/// Precision of one query's list at those levels. P(k) is the precision at the k-th hit, where the recall is k / R.
///
/// psb: linear interpolation between the hits below and above the level (Princeton Shape Benchmark, psbPlot); P(1) at
/// levels below the first hit.
/// paper: P(k) of the last hit with a recall of at most the level; 1 where there is none, as at level 0 (the point
/// (0, 1) in front of the curve).
Eigen::VectorXd precision_at_levels(const RankedList& list, Protocol protocol);

/// The mean of the rows of `precisions` (lists or classes of lists x levels), where row i comes from lists with
/// relevant[i] relevant models each. As psbPlot has it, under psb a row counts at a level only where the level is at
/// least 1 / R, because before the first hit no precision is defined; where no row counts (psbPlot prints 0 there), all
/// do, with P(1). Under paper all rows count everywhere.
PrecisionRecallCurve average_curve(const Eigen::MatrixXd& precisions, std::span<const std::size_t> relevant,
                                   Protocol protocol);

}  // namespace shapegauge
