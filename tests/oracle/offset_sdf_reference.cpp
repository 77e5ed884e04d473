// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracle/offset_sdf_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace shapegauge {

namespace {

/// Cubes of the search for the closest exterior point, the closest to p first.
struct DistanceCube {
  double bound;
  Eigen::Vector3d centre;
  double half;
  bool operator>(const DistanceCube& other) const { return bound > other.bound; }
};

}  // namespace

OffsetSdfReference::OffsetSdfReference(const Shape& shape, double r) : r_(r), spacing_(r / 5) {
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return shape.vertices.row(shape.triangles(f, k)); };
    const Eigen::Vector3d centre = (corner(0) + corner(1) + corner(2)) / 3;
    const auto reach = [&](int k) { return (corner(k) - centre).norm(); };
    triangles_.push_back({{corner(0), corner(1), corner(2)}, centre, std::max({reach(0), reach(1), reach(2)})});
  }
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(r + 3 * spacing_);
  low_ = shape.vertices.colwise().minCoeff().transpose() - margin;
  const Eigen::Vector3d extent = shape.vertices.colwise().maxCoeff().transpose() + margin - low_;
  size_ = (extent / spacing_).array().ceil().cast<int>();
  flood();
}

double OffsetSdfReference::distance(const Eigen::Vector3d& x) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [triangle, centre, radius] : triangles_) {
    if ((centre - x).norm() - radius >= least) continue;
    least = std::min(least, (closest_point(triangle, x) - x).norm());
  }
  return least;
}

Eigen::Vector3i OffsetSdfReference::cell_of(const Eigen::Vector3d& x) const {
  return ((x - low_) / spacing_).array().floor().cast<int>();
}

Eigen::Vector3d OffsetSdfReference::centre_of(const Eigen::Vector3i& cell) const {
  return low_ + spacing_ * (cell.cast<double>().array() + 0.5).matrix();
}

bool OffsetSdfReference::is_in_grid(const Eigen::Vector3i& cell) const {
  return (cell.array() >= 0).all() && (cell.array() < size_.array()).all();
}

std::size_t OffsetSdfReference::index_of(const Eigen::Vector3i& cell) const {
  return static_cast<std::size_t>((static_cast<long>(cell[2]) * size_[1] + cell[1]) * size_[0] + cell[0]);
}

void OffsetSdfReference::flood() {
  exterior_.assign(static_cast<std::size_t>(size_.cast<long>().prod()), 0);
  std::vector<Eigen::Vector3i> waiting{Eigen::Vector3i::Zero()};
  exterior_[0] = 1;
  while (!waiting.empty()) {
    const Eigen::Vector3i cell = waiting.back();
    waiting.pop_back();
    for (int axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        Eigen::Vector3i next = cell;
        next[axis] += step;
        if (!is_in_grid(next) || exterior_[index_of(next)] != 0 || distance(centre_of(next)) <= r_) continue;
        exterior_[index_of(next)] = 1;
        waiting.push_back(next);
      }
    }
  }
}

bool OffsetSdfReference::grid_is_exterior_within(const Eigen::Vector3d& x, double distance) const {
  const int reach = static_cast<int>(std::ceil(distance / spacing_));
  const Eigen::Vector3i middle = cell_of(x);
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      for (int k = -reach; k <= reach; ++k) {
        const Eigen::Vector3i cell = middle + Eigen::Vector3i(i, j, k);
        if (!is_in_grid(cell) || exterior_[index_of(cell)] != 0) return true;
      }
    }
  }
  return false;
}

bool OffsetSdfReference::is_exterior(const Eigen::Vector3d& x, double factor) const {
  // Free points on two sides of a surface are at least 2r apart: a cell of the exterior this near is on the same side.
  return grid_is_exterior_within(x, 2 * spacing_) && distance(x) >= factor * r_;
}

bool OffsetSdfReference::is_resolved(const Eigen::Vector3d& x) const {
  const double cell_radius = std::sqrt(3.0) / 2 * spacing_;
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      for (int k = -2; k <= 2; ++k) {
        if (distance(x + spacing_ * Eigen::Vector3d(i, j, k)) > r_ + cell_radius) return true;
      }
    }
  }
  return false;
}

double OffsetSdfReference::distance_to_exterior(const Eigen::Vector3d& p) const {
  const double extent = spacing_ * size_.maxCoeff();
  std::priority_queue<DistanceCube, std::vector<DistanceCube>, std::greater<>> waiting;
  waiting.push({0, p, extent});
  while (true) {
    const DistanceCube cube = waiting.top();
    waiting.pop();
    const double radius = std::sqrt(3.0) * cube.half;
    if (cube.half < r_ / 2 && !grid_is_exterior_within(cube.centre, radius + 2 * spacing_)) continue;
    const double d = distance(cube.centre);
    if (d + radius < r_) continue;
    if (radius < 2e-3 * r_ && is_exterior(cube.centre)) return (cube.centre - p).norm();
    if (radius < 1e-3 * r_) continue;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d direction((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
      const Eigen::Vector3d centre = cube.centre + cube.half / 2 * direction;
      const double bound = ((p - centre).cwiseAbs().array() - cube.half / 2).cwiseMax(0).matrix().norm();
      waiting.push({bound, centre, cube.half / 2});
    }
  }
}

double OffsetSdfReference::distance_from_raised(const std::array<Eigen::Vector3d, 2>& raised) const {
  return std::min(distance_to_exterior(raised[0]), distance_to_exterior(raised[1]));
}

double OffsetSdfReference::exit(const Eigen::Vector3d& p, const Eigen::Vector3d& direction, double factor) const {
  double t = 0;
  while (!is_exterior(p + t * direction, factor)) t += r_ / 500;
  return t;
}

}  // namespace shapegauge
