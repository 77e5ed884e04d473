#include "shapegauge/metrics/precision_recall.h"

namespace shapegauge {
namespace {

// Levels are the multiples of 1 / divisions, and are compared with recalls k / R in whole numbers: no rounding decides
// whether a hit is in.
constexpr std::size_t divisions_of(Protocol protocol) { return protocol == Protocol::psb ? 20 : 10; }
constexpr std::size_t first_level_of(Protocol protocol) { return protocol == Protocol::psb ? 1 : 0; }

double interpolated(const std::vector<double>& precision_at_hit, std::size_t level, std::size_t divisions) {
  const std::size_t position = level * precision_at_hit.size();
  const std::size_t hits = position / divisions;
  if (hits == 0) return precision_at_hit.front();
  const double below = precision_at_hit[hits - 1];
  if (position % divisions == 0) return below;
  const double fraction = static_cast<double>(position % divisions) / static_cast<double>(divisions);
  return below + fraction * (precision_at_hit[hits] - below);
}

double last_reached(const std::vector<double>& precision_at_hit, std::size_t level, std::size_t divisions) {
  const std::size_t hits = level * precision_at_hit.size() / divisions;
  return hits == 0 ? 1.0 : precision_at_hit[hits - 1];
}

// The mean of the chosen entries of a column, from the first row to the last; nothing chosen: 0 entries.
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

std::vector<double> recall_levels(Protocol protocol) {
  const std::size_t divisions = divisions_of(protocol);
  std::vector<double> levels;
  for (std::size_t level = first_level_of(protocol); level <= divisions; ++level) {
    levels.push_back(static_cast<double>(level) / static_cast<double>(divisions));
  }
  return levels;
}

Eigen::VectorXd precision_at_levels(const RankedList& list, Protocol protocol) {
  std::vector<double> precision_at_hit;
  for (const std::size_t rank : ranks_of_hits(list)) {
    precision_at_hit.push_back(static_cast<double>(precision_at_hit.size() + 1) / static_cast<double>(rank));
  }
  const std::size_t divisions = divisions_of(protocol);
  const std::size_t first = first_level_of(protocol);
  Eigen::VectorXd precisions(static_cast<Eigen::Index>(divisions + 1 - first));
  for (std::size_t level = first; level <= divisions; ++level) {
    precisions[static_cast<Eigen::Index>(level - first)] = protocol == Protocol::psb
                                                               ? interpolated(precision_at_hit, level, divisions)
                                                               : last_reached(precision_at_hit, level, divisions);
  }
  return precisions;
}

PrecisionRecallCurve average_curve(const Eigen::MatrixXd& precisions, std::span<const std::size_t> relevant,
                                   Protocol protocol) {
  const std::size_t divisions = divisions_of(protocol);
  PrecisionRecallCurve curve;
  curve.recall = recall_levels(protocol);
  for (Eigen::Index column = 0; column < precisions.cols(); ++column) {
    const std::size_t level = first_level_of(protocol) + static_cast<std::size_t>(column);
    const auto reaches_a_hit = [&](std::size_t row) { return level * relevant[row] >= divisions; };
    const auto any = [](std::size_t) { return true; };
    Mean mean;
    if (protocol == Protocol::psb) mean = mean_of_column(precisions, column, reaches_a_hit);
    if (mean.count == 0) mean = mean_of_column(precisions, column, any);
    curve.precision.push_back(mean.sum / static_cast<double>(mean.count));
  }
  return curve;
}

}  // namespace shapegauge
