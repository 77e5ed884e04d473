// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/cylinder_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

namespace {

/// Vertex in the coordinates of a cylinder.
struct CylinderPoint {
  double row;              ///< height, in rows: row k has its centre at k + 0.5
  Eigen::Vector2d across;  ///< position in the plane across the axis, in radii
};

/// Intersection of a triangle with a plane across the axis, counterclockwise as seen from the axis.
struct PlaneCut {
  Eigen::Vector2d first;
  Eigen::Vector2d last;
};

std::optional<PlaneCut> cut_at(const std::array<CylinderPoint, 3>& corners, double row) {
  std::array<Eigen::Vector2d, 2> ends;
  std::size_t found = 0;
  for (std::size_t k = 0; k < 3 && found < 2; ++k) {
    const CylinderPoint* a = &corners[k];
    const CylinderPoint* b = &corners[(k + 1) % 3];
    if ((a->row <= row) == (b->row <= row)) continue;
    if (b->row < a->row) std::swap(a, b);  // two triangles that share an edge are cut at exactly the same point
    ends[found++] = a->across + (row - a->row) / (b->row - a->row) * (b->across - a->across);
  }
  if (found < 2) return std::nullopt;
  if (ends[0].x() * ends[1].y() < ends[0].y() * ends[1].x()) std::swap(ends[0], ends[1]);
  return PlaneCut{ends[0], ends[1]};
}

class CylinderProjection {
 public:
  explicit CylinderProjection(const CylinderFrame& frame)
      : angles_(frame.angles), heights_(frame.heights), directions_(2, frame.angles) {
    map_.distance = map_.cosine = CylinderGrid::Zero(frame.heights, frame.angles);
    for (Eigen::Index j = 0; j < frame.angles; ++j) {
      const double angle = 2 * std::numbers::pi * (static_cast<double>(j) + 0.5) / frame.angles;
      directions_.col(j) << std::cos(angle), std::sin(angle);
    }
  }

  /// Draws a triangle into the rows that it covers. `normal` is its unit normal, projected across the axis.
  void add(const std::array<CylinderPoint, 3>& corners, const Eigen::Vector2d& normal) {
    const auto [low, high] = std::minmax({corners[0].row, corners[1].row, corners[2].row});
    if (!(high >= 0.5 && low <= heights_ - 0.5)) return;
    const int first = static_cast<int>(std::ceil(std::max(low, 0.5) - 0.5));
    const int last = static_cast<int>(std::floor(std::min(high, heights_ - 0.5) - 0.5));
    for (int row = first; row <= last; ++row) {
      if (const auto cut = cut_at(corners, row + 0.5)) add_cut(row, *cut, normal);
    }
  }

  CylinderMap take() { return std::move(map_); }

 private:
  /// Returns the angle in columns; the centre of column k is at k + 0.5.
  [[nodiscard]] double column_of(const Eigen::Vector2d& at) const {
    return std::atan2(at.y(), at.x()) / (2 * std::numbers::pi) * angles_;
  }

  void add_cut(int row, const PlaneCut& cut, const Eigen::Vector2d& normal) {
    const double area = cut.first.x() * cut.last.y() - cut.first.y() * cut.last.x();
    // Seen from the edge, it is as wide as rounding errors.
    constexpr double widest_edge = 1e-12;
    if (!(area * area > widest_edge * widest_edge * cut.first.squaredNorm() * cut.last.squaredNorm())) return;
    const Eigen::Vector2d along = cut.last - cut.first;
    constexpr double rounding = 1e-9;  // rays between two cuts that touch must meet one of them
    const double from = column_of(cut.first);
    double to = column_of(cut.last);
    if (to < from) to += angles_;
    const int end = static_cast<int>(std::floor(to - 0.5 + rounding));
    for (int column = static_cast<int>(std::ceil(from - 0.5 - rounding)); column <= end; ++column) {
      const Eigen::Index j = (column + angles_) % angles_;
      const auto direction = directions_.col(j);
      const double slope = direction.x() * along.y() - direction.y() * along.x();
      const double distance = area / slope;
      if (!(distance > map_.distance(row, j) && distance <= 1)) continue;
      map_.distance(row, j) = static_cast<float>(distance);
      map_.cosine(row, j) = static_cast<float>(std::abs(normal.dot(direction)));
    }
  }

  int angles_;
  int heights_;
  Eigen::Matrix2Xd directions_;
  CylinderMap map_;
};

}  // namespace

CylinderMap project_on_cylinder(const Shape& mesh, const CylinderFrame& frame) {
  const int u = (frame.axis + 1) % 3;
  const int v = (frame.axis + 2) % 3;
  CylinderProjection projection(frame);
  const SparseInterruptionCheck check;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    check();
    std::array<Eigen::Vector3d, 3> corners;
    std::array<CylinderPoint, 3> seen;
    for (int k = 0; k < 3; ++k) {
      corners[k] = mesh.vertices.row(mesh.triangles(f, k)).transpose() / frame.radius;
      seen[k] = {(corners[k][frame.axis] + 1) / 2 * frame.heights, {corners[k][u], corners[k][v]}};
    }
    const Eigen::Vector3d cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double length = cross.norm();
    if (length > 0) projection.add(seen, Eigen::Vector2d(cross[u], cross[v]) / length);
  }
  return projection.take();
}

}  // namespace shapegauge
