// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/check/thin_cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

namespace {

/// Minimum angle between walls, as normals that point away from each other, in degrees.
constexpr double wall_angle = 150;

/// Number of cells of the largest size on the whole surface, beyond which spacing() is larger than the limit.
constexpr double max_cells = 250'000;

/// Index of the corner at which the longest side begins.
std::size_t longest_side(const Cell& cell) {
  std::array<double, 3> lengths{};
  for (std::size_t k = 0; k < 3; ++k) lengths[k] = (cell.corners[(k + 1) % 3] - cell.corners[k]).squaredNorm();
  return static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
}

double size_of(const Cell& cell) {
  const std::size_t k = longest_side(cell);
  return (cell.corners[(k + 1) % 3] - cell.corners[k]).norm();
}

double area_of(const Cell& cell) {
  return (cell.corners[1] - cell.corners[0]).cross(cell.corners[2] - cell.corners[0]).norm() / 2;
}

std::array<Cell, 2> halves_of(const Cell& cell) {
  const std::size_t k = longest_side(cell);
  const Eigen::Vector3d middle = (cell.corners[k] + cell.corners[(k + 1) % 3]) / 2;
  std::array<Cell, 2> halves{cell, cell};
  halves[0].corners[(k + 1) % 3] = middle;
  halves[1].corners[k] = middle;
  return halves;
}

/// Returns the point near a corner at which a cell is sampled. At the corner itself, the triangles around it touch.
Eigen::Vector3d sample_near(const Cell& cell, std::size_t corner) {
  constexpr double inset = 1.0 / 32;
  const Eigen::Vector3d middle = (cell.corners[0] + cell.corners[1] + cell.corners[2]) / 3;
  return cell.corners[corner] + inset * (middle - cell.corners[corner]);
}

}  // namespace

std::vector<Cell> cells_of(const Shape& mesh) {
  const Welding welding = welding_of(mesh);
  std::vector<Cell> cells;
  for (std::int32_t f = 0; f < mesh.triangles.rows(); ++f) {
    if (!welding.is_distinct(f) || is_degenerate(mesh, f)) continue;
    Cell cell{.corners = {}, .face = f};
    for (int k = 0; k < 3; ++k) {
      cell.corners[static_cast<std::size_t>(k)] = mesh.vertices.row(mesh.triangles(f, k)).transpose();
    }
    cells.push_back(cell);
  }
  return cells;
}

std::vector<Cell> DividedCells::all() const {
  std::vector<Cell> cells;
  for (const ThinCell& cell : thin) cells.push_back(cell.cell);
  cells.insert(cells.end(), others.begin(), others.end());
  return cells;
}

CellSampler::CellSampler(const Shape& mesh, const TouchingBalls& balls, BallSide side, double limit, bool parallel)
    : mesh_(mesh),
      balls_(balls),
      side_(side),
      limit_(limit),
      parallel_(parallel),
      spacing_(std::max(limit, std::sqrt(surface_area(mesh) / max_cells))) {}

DividedCells CellSampler::divide(std::vector<Cell> pending) const {
  constexpr std::size_t batch_size = 65536;
  for (std::size_t i = 0; i < pending.size(); ++i) pending[i].origin = static_cast<std::int32_t>(i);
  DividedCells cells;
  while (!pending.empty()) {
    const std::size_t begin = pending.size() - std::min(batch_size, pending.size());
    const std::vector<Cell> batch(pending.begin() + static_cast<std::ptrdiff_t>(begin), pending.end());
    pending.resize(begin);
    std::vector<Finding> findings(batch.size());
    for_each_index(parallel_, std::size_t{0}, batch.size(), [&](std::size_t i) { findings[i] = examine(batch[i]); });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (findings[i].thin) {
        cells.thin.push_back(*findings[i].thin);
      } else if (!findings[i].split) {
        cells.others.push_back(batch[i]);
      } else {
        for (const Cell& half : halves_of(batch[i])) pending.push_back(half);
      }
    }
  }
  mark_edges(cells.thin);
  return cells;
}

CellSampler::Finding CellSampler::examine(const Cell& cell) const {
  const auto& [a, b, c] = cell.corners;
  if (!balls_.may_touch({a, b, c}, triangle_normal(mesh_, cell.face).transpose(), side_, limit_)) return {};
  const double size = size_of(cell);
  if (size > spacing_) return {.split = true};
  ThinCell thin{.cell = cell, .diameters = {}};
  int below = 0;
  int edges = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<TouchingBall> ball = ball_at(cell, sample_near(cell, k));
    if (!ball) continue;
    ++below;
    if (ball->angle_degrees < wall_angle) ++edges;
    thin.diameters[k] = ball->diameter;
  }
  if (below == 0) return {};
  if (below < 3 && size > border_size * limit_) return {.split = true};
  thin.area = area_of(cell) * fraction_below(thin);
  thin.is_edge = 2 * edges > below;
  return {.thin = thin};
}

/// Keeps those cells at edges near which the diameter reaches the limit.
void CellSampler::mark_edges(std::vector<ThinCell>& cells) const {
  std::vector<Eigen::Vector3d> centres;  // of balls of the limit's diameter along the borders of regions
  for (const ThinCell& thin : cells) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!thin.diameters[k]) centres.push_back(ball_centre(thin.cell, k, limit_));
    }
  }
  Shape cloud{.vertices = Points(std::ssize(centres), 3), .triangles = {}};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    cloud.vertices.row(static_cast<Eigen::Index>(i)) = centres[i].transpose();
  }
  const UnitFrame frame = unit_frame(mesh_);
  const TriangleBVH openings(in_unit_frame(cloud, frame));
  for_each_index(parallel_, std::size_t{0}, cells.size(), [&](std::size_t i) {
    cells[i].is_edge = cells[i].is_edge && opens_to_limit(cells[i], openings, frame);
  });
}

/// Returns true if balls of the limit's diameter are so near as between walls that open by 180 degrees less
/// `wall_angle`, or nearer.
bool CellSampler::opens_to_limit(const ThinCell& thin, const TriangleBVH& openings, const UnitFrame& frame) const {
  const double half_opening = (180 - wall_angle) / 360 * std::numbers::pi;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!thin.diameters[k]) continue;
    const double growth = (limit_ - *thin.diameters[k]) / 2;
    const double reach = growth / std::sin(half_opening) + 2 * border_size * limit_;
    const Eigen::Vector3d centre = ball_centre(thin.cell, k, *thin.diameters[k]);
    if (!openings.closest(frame.to_unit(centre), reach / frame.diagonal)) return false;
  }
  return true;
}

Eigen::Vector3d CellSampler::ball_centre(const Cell& cell, std::size_t corner, double diameter) const {
  const double sign = side_ == BallSide::inside ? -1 : 1;
  return sample_near(cell, corner) + sign * diameter / 2 * triangle_normal(mesh_, cell.face).transpose();
}

std::optional<TouchingBall> CellSampler::ball_at(const Cell& cell, const Eigen::Vector3d& point) const {
  return balls_.ball_at(point, triangle_normal(mesh_, cell.face).transpose(), side_, limit_);
}

double CellSampler::crossing(const Cell& cell, const Eigen::Vector3d& below, const Eigen::Vector3d& above) const {
  double low = 0;
  double high = 1;
  for (int step = 0; step < 5; ++step) {
    const double middle = (low + high) / 2;
    (ball_at(cell, below + middle * (above - below)) ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Returns the fraction of a cell below the limit. The border of the region is assumed to cross it in a straight line.
double CellSampler::fraction_below(const ThinCell& thin) const {
  const auto below = std::ranges::count_if(thin.diameters, &std::optional<double>::has_value);
  if (below == 3) return 1;
  // The corner alone on its side of the border.
  std::size_t lone = 0;
  while (thin.diameters[lone].has_value() != (below == 1)) ++lone;
  double triangle = 1;
  for (const std::size_t k : {(lone + 1) % 3, (lone + 2) % 3}) {
    const Eigen::Vector3d here = sample_near(thin.cell, lone);
    const Eigen::Vector3d there = sample_near(thin.cell, k);
    triangle *= below == 1 ? crossing(thin.cell, here, there) : 1 - crossing(thin.cell, there, here);
  }
  return below == 1 ? triangle : 1 - triangle;
}

SampledBall CellSampler::smallest_ball_in(const ThinCell& thin) const {
  const double finest = 1e-3 * limit_;
  std::optional<SampledBall> least;
  // Returns the smallest diameter in a cell, and keeps the least of all.
  const auto smallest_in = [&](const Cell& cell) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d position = sample_near(cell, k);
      const std::optional<TouchingBall> ball = ball_at(cell, position);
      if (!ball) continue;
      smallest = std::min(smallest, ball->diameter);
      if (!least || ball->diameter < least->ball.diameter) least = SampledBall{position, *ball};
    }
    return smallest;
  };
  Cell cell = thin.cell;
  smallest_in(cell);
  while (size_of(cell) > finest) {
    const std::array<Cell, 2> halves = halves_of(cell);
    const double first = smallest_in(halves[0]);
    cell = halves[first <= smallest_in(halves[1]) ? 0 : 1];
  }
  return least.value();
}

}  // namespace shapegauge
