// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/words.h"
#include "shapegauge/metrics/protocol.h"
#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// Interpolation of a precision-recall curve from P(k), the precision at the k-th hit, where the recall is k / R, for a
/// query with R relevant models.
/// - psb: at recalls 0.05, 0.10, ... 1.0, linear between the hits below and above the level (Princeton Shape Benchmark,
///   psbPlot); P(1) at levels below the first hit.
/// - paper: at 0, 0.1, ... 1.0, P(k) of the last hit with a recall of at most the level; 1 if there is none, as at
///   level 0 (the initial point (0, 1)).
/// - trec: at 0, 0.1, ... 1.0, the maximum P(k) of the hits with a recall of at least the level (trec_eval's
///   iprec_at_recall). Under Ties::expected the P(k) are means over the orders of tied models. The maximum of means may
///   be less than the mean of maxima, for which there is no closed form.
/// - raw: at 1/L, 2/L, ... 1, where L is the largest number of relevant models of any query, P(k) of the first hit that
///   reaches the level. If all queries have L relevant models, these are the hits themselves.
/// - trec_eval: like trec, but a recall level p is reached by p R hits, rounded to an integer, as in trec_eval 10.
enum class CurveKind { psb, paper, trec, raw, trec_eval };
template <>
inline constexpr std::array<std::string_view, 5> words_of<CurveKind>{"psb", "paper", "trec", "raw", "trec_eval"};

/// Returns the default kind of curve of a protocol: the CurveKind with the same name.
CurveKind default_curve(Protocol protocol);

/// Precision at fixed levels of recall, averaged over queries.
struct PrecisionRecallCurve {
  std::vector<double> recall;     ///< recall levels, ascending
  std::vector<double> precision;  ///< mean precision at each recall level
};

/// Returns the recall levels of a kind of curve, ascending. `largest_relevant` is the largest number of relevant models
/// of any query; only CurveKind::raw uses it.
std::vector<double> recall_levels(CurveKind kind, std::size_t largest_relevant = 1);

/// Computes the precision of the ranked list of one query at each of recall_levels(kind, largest_relevant); 0 for an
/// empty list.
Eigen::VectorXd precision_at_levels(const RankedList& list, CurveKind kind, std::size_t largest_relevant = 1);

/// Averages the rows of `precisions` (queries or classes x recall levels) into one curve. relevant[i] is the number R
/// of relevant models of the query of row i, or the largest R in its class. Under psb, as in psbPlot, a row counts at a
/// level only if the level is at least 1 / R, because no precision is defined before the first hit. If no row counts
/// (psbPlot prints 0), all do, with P(1). Under the other kinds all rows count everywhere.
PrecisionRecallCurve average_curve(const Eigen::MatrixXd& precisions, std::span<const std::size_t> relevant,
                                   CurveKind kind);

}  // namespace shapegauge
