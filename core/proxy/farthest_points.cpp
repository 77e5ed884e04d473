// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/proxy/farthest_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

namespace {

/// Consecutive samples, close to each other because of the Morton order.
struct SampleBlock {
  Eigen::Index first;
  Eigen::Index last;  ///< one after the end
  Eigen::Array3d low;
  Eigen::Array3d high;
  double farthest = std::numeric_limits<double>::infinity();  ///< maximum squared distance of a sample
};

std::vector<SampleBlock> blocks_of(const Points& points) {
  constexpr Eigen::Index size = 48;
  std::vector<SampleBlock> blocks;
  for (Eigen::Index first = 0; first < points.rows(); first += size) {
    const Eigen::Index last = std::min(first + size, points.rows());
    const auto rows = points.middleRows(first, last - first);
    blocks.push_back(
        {first, last, rows.colwise().minCoeff().transpose().array(), rows.colwise().maxCoeff().transpose().array()});
  }
  return blocks;
}

double squared_distance(const SampleBlock& block, const Eigen::Array3d& point) {
  return (block.low - point).max(point - block.high).max(0.0).matrix().squaredNorm();
}

Eigen::Index outermost_sample(const DenseSamples& samples) {
  const Eigen::RowVector3d centroid = samples.areas.transpose() * samples.points / samples.areas.sum();
  Eigen::Index farthest = 0;
  (samples.points.rowwise() - centroid).rowwise().squaredNorm().maxCoeff(&farthest);
  return farthest;
}

/// State of the farthest-point selection.
class FarthestPointSelection {
 public:
  FarthestPointSelection(const DenseSamples& samples, Eigen::Index count)
      : samples_(samples),
        blocks_(blocks_of(samples.points)),
        squared_(Eigen::VectorXd::Constant(samples.points.rows(), std::numeric_limits<double>::infinity())),
        always_covered_(0.01 * samples.areas.sum() / static_cast<double>(count)) {
    result_.nearest.assign(static_cast<std::size_t>(samples.points.rows()), 0);
  }

  void add(Eigen::Index sample) {
    const auto index = static_cast<std::int32_t>(result_.chosen.size());
    result_.chosen.push_back(static_cast<std::int32_t>(sample));
    const Eigen::Array3d point = samples_.points.row(sample).transpose().array();
    for (SampleBlock& block : blocks_) {
      if (squared_distance(block, point) < block.farthest) cover(block, sample, index);
    }
  }

  /// Returns the sample farthest from those chosen, and its squared distance.
  [[nodiscard]] std::pair<Eigen::Index, double> farthest() const {
    const auto block = std::ranges::max_element(blocks_, {}, &SampleBlock::farthest);
    Eigen::Index offset = 0;
    const double distance = squared_.segment(block->first, block->last - block->first).maxCoeff(&offset);
    return {block->first + offset, distance};
  }

  FarthestPoints result() && {
    result_.covering_radius = std::sqrt(farthest().second);
    return std::move(result_);
  }

 private:
  void cover(SampleBlock& block, Eigen::Index sample, std::int32_t index) {
    constexpr double agreeing = 0.3;
    double farthest = 0;
    for (Eigen::Index i = block.first; i < block.last; ++i) {
      const double squared = (samples_.points.row(i) - samples_.points.row(sample)).squaredNorm();
      if (squared < squared_[i] &&
          (squared <= always_covered_ ||
           normal_agreement(samples_, static_cast<std::int32_t>(i), static_cast<std::int32_t>(sample)) > agreeing)) {
        squared_[i] = squared;
        result_.nearest[static_cast<std::size_t>(i)] = index;
      }
      farthest = std::max(farthest, squared_[i]);
    }
    block.farthest = farthest;
  }

  const DenseSamples& samples_;
  std::vector<SampleBlock> blocks_;
  Eigen::VectorXd squared_;
  double always_covered_;
  FarthestPoints result_;
};

}  // namespace

FarthestPoints farthest_points(const DenseSamples& samples, Eigen::Index count) {
  FarthestPointSelection selection(samples, count);
  Eigen::Index next = outermost_sample(samples);
  for (Eigen::Index k = 0; k < count; ++k) {
    check_interruption();
    selection.add(next);
    const auto [farthest, squared] = selection.farthest();
    if (!(squared > 0)) break;
    next = farthest;
  }
  return std::move(selection).result();
}

}  // namespace shapegauge
