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

/// Interpolation of a precision-recall curve from P(k), the precision at the k-th hit, where the recall is k / R.
/// - psb: at recalls 0.05, 0.10, ... 1.0, linear between the hits below and above the level (Princeton Shape Benchmark,
///   psbPlot); P(1) at levels below the first hit.
/// - paper: at 0, 0.1, ... 1.0, P(k) of the last hit with a recall of at most the level; 1 if there is none, as at
///   level 0 (the initial point (0, 1)).
/// - trec: at 0, 0.1, ... 1.0, the maximum P(k) of the hits with a recall of at least the level (trec_eval's
///   iprec_at_recall). Under Ties::expected the P(k) are means over the orders of tied models. The maximum of means may
///   be less than the mean of maxima, for which there is no closed form.
/// - raw: at 1/L, 2/L, ... 1, where L is the largest number of relevant models of any query, P(k) of the first hit that
///   reaches the level. If every query has as many relevant models, these are the hits themselves.
/// - trec_eval: like trec, but a level p is reached by p R hits rounded to the nearest number, as in trec_eval 10.
enum class CurveKind { psb, paper, trec, raw, trec_eval };
template <>
inline constexpr std::array<std::string_view, 5> words_of<CurveKind>{"psb", "paper", "trec", "raw", "trec_eval"};

/// Returns the default curve of a protocol, which has the same name.
CurveKind default_curve(Protocol protocol);

/// Precision at fixed levels of recall, averaged over queries.
struct PrecisionRecallCurve {
  std::vector<double> recall;
  std::vector<double> precision;
};

/// Returns the recall levels of a kind of curve. Only raw uses the largest number of relevant models.
std::vector<double> recall_levels(CurveKind kind, std::size_t largest_relevant = 1);

/// Computes the precision of one query's list at the recall levels.
Eigen::VectorXd precision_at_levels(const RankedList& list, CurveKind kind, std::size_t largest_relevant = 1);

/// Averages the rows of `precisions` (lists, or classes of lists, x levels). Row i comes from lists with relevant[i]
/// relevant models each. Under psb, as in psbPlot, a row counts at a level only if the level is at least 1 / R, because
/// no precision is defined before the first hit. If no row counts (psbPlot prints 0), all do, with P(1). Under the
/// other kinds all rows count everywhere.
PrecisionRecallCurve average_curve(const Eigen::MatrixXd& precisions, std::span<const std::size_t> relevant,
                                   CurveKind kind);

}  // namespace shapegauge
