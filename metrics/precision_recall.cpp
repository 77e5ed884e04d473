// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/precision_recall.h"

#include <algorithm>
#include <cmath>

namespace shapegauge {
namespace {

// Returns the divisor of the levels, which are multiples of 1 / divisions. They are compared with recalls k / R in
// integers, without rounding.
std::size_t divisions_of(CurveKind kind, std::size_t largest_relevant) {
  if (kind == CurveKind::raw) return largest_relevant;
  return kind == CurveKind::psb ? 20 : 10;
}

std::size_t first_level_of(CurveKind kind) { return kind == CurveKind::psb || kind == CurveKind::raw ? 1 : 0; }

using Precisions = std::vector<double>;  // at the hits

double interpolated(const Precisions& precision_at_hit, std::size_t level, std::size_t divisions) {
  const std::size_t position = level * precision_at_hit.size();
  const std::size_t hits = position / divisions;
  if (hits == 0) return precision_at_hit.front();
  const double below = precision_at_hit[hits - 1];
  if (position % divisions == 0) return below;
  const double fraction = static_cast<double>(position % divisions) / static_cast<double>(divisions);
  return below + fraction * (precision_at_hit[hits] - below);
}

double last_reached(const Precisions& precision_at_hit, std::size_t level, std::size_t divisions) {
  const std::size_t hits = level * precision_at_hit.size() / divisions;
  return hits == 0 ? 1.0 : precision_at_hit[hits - 1];
}

// Returns the index of the first hit with a recall of at least the level.
std::size_t first_reaching(const Precisions& precision_at_hit, std::size_t level, std::size_t divisions) {
  const std::size_t hits = (level * precision_at_hit.size() + divisions - 1) / divisions;
  return std::max<std::size_t>(hits, 1) - 1;
}

double largest_from(const Precisions& precision_at_hit, std::size_t first) {
  return *std::max_element(precision_at_hit.begin() + static_cast<std::ptrdiff_t>(first), precision_at_hit.end());
}

// Returns the index of the first hit that trec_eval takes for the level.
std::size_t first_in_trec_eval(const Precisions& precision_at_hit, std::size_t level, std::size_t divisions) {
  const double recall = static_cast<double>(level) / static_cast<double>(divisions);
  const auto hits = static_cast<std::size_t>(std::lround(recall * static_cast<double>(precision_at_hit.size())));
  return std::max<std::size_t>(hits, 1) - 1;
}

double precision_at(const Precisions& precision_at_hit, CurveKind kind, std::size_t level, std::size_t divisions) {
  switch (kind) {
    case CurveKind::psb:
      return interpolated(precision_at_hit, level, divisions);
    case CurveKind::paper:
      return last_reached(precision_at_hit, level, divisions);
    case CurveKind::trec:
      return largest_from(precision_at_hit, first_reaching(precision_at_hit, level, divisions));
    case CurveKind::trec_eval:
      return largest_from(precision_at_hit, first_in_trec_eval(precision_at_hit, level, divisions));
    case CurveKind::raw:
      break;
  }
  return precision_at_hit[first_reaching(precision_at_hit, level, divisions)];
}

std::vector<double> levels_of(std::size_t first, std::size_t divisions) {
  std::vector<double> levels;
  for (std::size_t level = first; level <= divisions; ++level) {
    levels.push_back(static_cast<double>(level) / static_cast<double>(divisions));
  }
  return levels;
}

// Mean of the chosen entries of a column; 0 entries if nothing is chosen.
struct Mean {
  double sum = 0;
  std::size_t count = 0;
};

template <typename Chosen>
Mean mean_of_column(const Eigen::MatrixXd& table, Eigen::Index column, const Chosen& chosen) {
  Mean mean;
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    if (!chosen(static_cast<std::size_t>(row))) continue;
    mean.sum += table(row, column);
    ++mean.count;
  }
  return mean;
}

}  // namespace

CurveKind default_curve(Protocol protocol) { return value_of_word<CurveKind>(word_of(protocol)).value(); }

std::vector<double> recall_levels(CurveKind kind, std::size_t largest_relevant) {
  return levels_of(first_level_of(kind), divisions_of(kind, largest_relevant));
}

Eigen::VectorXd precision_at_levels(const RankedList& list, CurveKind kind, std::size_t largest_relevant) {
  const std::size_t divisions = divisions_of(kind, largest_relevant);
  const std::size_t first = first_level_of(kind);
  Eigen::VectorXd precisions = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(divisions + 1 - first));
  if (list.length == 0 || list.relevant == 0) return precisions;
  for (std::size_t level = first; level <= divisions; ++level) {
    precisions[static_cast<Eigen::Index>(level - first)] = precision_at(list.precision_at_hit, kind, level, divisions);
  }
  return precisions;
}

PrecisionRecallCurve average_curve(const Eigen::MatrixXd& precisions, std::span<const std::size_t> relevant,
                                   CurveKind kind) {
  const std::size_t first = first_level_of(kind);
  const std::size_t divisions = static_cast<std::size_t>(precisions.cols()) + first - 1;
  PrecisionRecallCurve curve;
  curve.recall = levels_of(first, divisions);
  for (Eigen::Index column = 0; column < precisions.cols(); ++column) {
    const std::size_t level = first + static_cast<std::size_t>(column);
    const auto reaches_a_hit = [&](std::size_t row) { return level * relevant[row] >= divisions; };
    const auto any = [](std::size_t) { return true; };
    Mean mean;
    if (kind == CurveKind::psb) mean = mean_of_column(precisions, column, reaches_a_hit);
    if (mean.count == 0) mean = mean_of_column(precisions, column, any);
    curve.precision.push_back(mean.sum / static_cast<double>(mean.count));
  }
  return curve;
}

}  // namespace shapegauge
