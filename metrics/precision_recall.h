#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/protocol.h"
#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// How a precision-recall curve is drawn from P(k), the precision at the k-th hit, where the recall is k / R.
///
/// psb: at recalls 0.05, 0.10, ... 1.0, linear interpolation between the hits below and above the level (Princeton
/// Shape Benchmark, psbPlot); P(1) at levels below the first hit. paper: at 0, 0.1, ... 1.0, P(k) of the last hit with
/// a recall of at most the level; 1 where there is none, as at level 0 (the point (0, 1) in front of the curve). trec:
/// at 0, 0.1, ... 1.0, the largest P(k) of the hits with a recall of at least the level (trec_eval's iprec_at_recall).
/// Under Ties::expected the P(k) are means over the orders of the tied, and the largest of means may be less than the
/// mean of the largest, for which there is no closed form. raw: no interpolation: at 1/L, 2/L, ... 1 for the largest
/// number L of relevant models of any query, P(k) of the first hit that reaches the level. Where every query has as
/// many relevant models these are the hits themselves.
enum class CurveKind { psb, paper, trec, raw };

/// The name in files and options: "psb", "paper", "trec" or "raw".
std::string name_of(CurveKind kind);

/// The kind of that name, or nothing.
std::optional<CurveKind> curve_kind_of(std::string_view name);

/// All names, for configurations and error messages.
std::vector<std::string> curve_kind_names();

/// The kind that is usual under a protocol: the one of its name.
CurveKind usual_curve(Protocol protocol);

/// Precision at fixed levels of recall, averaged over queries.
struct PrecisionRecallCurve {
  std::vector<double> recall;
  std::vector<double> precision;
};

/// The levels of recall of a kind of curve. Only raw looks at the largest number of relevant models.
std::vector<double> recall_levels(CurveKind kind, std::size_t largest_relevant = 1);

/// Precision of one query's list at those levels.
Eigen::VectorXd precision_at_levels(const RankedList& list, CurveKind kind, std::size_t largest_relevant = 1);

/// The mean of the rows of `precisions` (lists or classes of lists x levels), where row i comes from lists with
/// relevant[i] relevant models each. As psbPlot has it, under psb a row counts at a level only where the level is at
/// least 1 / R, because before the first hit no precision is defined; where no row counts (psbPlot prints 0 there), all
/// do, with P(1). Under the other kinds all rows count everywhere.
PrecisionRecallCurve average_curve(const Eigen::MatrixXd& precisions, std::span<const std::size_t> relevant,
                                   CurveKind kind);

}  // namespace shapegauge
