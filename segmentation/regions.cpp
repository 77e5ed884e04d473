// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/regions.h"

#include <numeric>

namespace shapegauge {

RegionSum& RegionSum::operator+=(const RegionSum& other) {
  nodes += other.nodes;
  area += other.area;
  thickness += other.thickness;
  squared_thickness += other.squared_thickness;
  position += other.position;
  squared_position += other.squared_position;
  squared_normal += other.squared_normal;
  histogram += other.histogram;
  return *this;
}

Regions::Regions(std::int32_t count)
    : size_(count),
      sums_(static_cast<std::size_t>(count)),
      neighbours_(static_cast<std::size_t>(count)),
      merged_into_(static_cast<std::size_t>(count)) {
  std::iota(merged_into_.begin(), merged_into_.end(), 0);
  pairs_.fill(Eigen::MatrixXd::Zero(count, count));
}

std::int32_t Regions::region_of(std::int32_t initial) const {
  while (merged_into_[static_cast<std::size_t>(initial)] != initial) {
    initial = merged_into_[static_cast<std::size_t>(initial)];
  }
  return initial;
}

double Regions::perimeter(std::int32_t region) const {
  const Eigen::MatrixXd& borders = pairs_[static_cast<std::size_t>(PairSum::border)];
  return borders.col(region).sum() - borders(region, region);
}

void Regions::make_neighbours(std::int32_t a, std::int32_t b) {
  neighbours_[static_cast<std::size_t>(a)].insert(b);
  neighbours_[static_cast<std::size_t>(b)].insert(a);
}

void Regions::merge(std::int32_t a, std::int32_t b) {
  sums_[static_cast<std::size_t>(a)] += sums_[static_cast<std::size_t>(b)];
  for (Eigen::MatrixXd& sums : pairs_) {
    const double within = sums(a, a) + sums(b, b) + sums(a, b) + sums(b, a);
    sums.col(a) += sums.col(b);
    sums.row(a) = sums.col(a).transpose();
    sums(a, a) = within;
    sums.col(b).setZero();
    sums.row(b).setZero();
  }
  std::set<std::int32_t>& around = neighbours_[static_cast<std::size_t>(b)];
  for (const std::int32_t other : around) {
    neighbours_[static_cast<std::size_t>(other)].erase(b);
    if (other != a) make_neighbours(a, other);
  }
  around.clear();
  merged_into_[static_cast<std::size_t>(b)] = a;
  merges_.emplace_back(a, b);
  --size_;
}

}  // namespace shapegauge
