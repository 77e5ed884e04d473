// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/preparation/gap_size.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "shapegauge/core/base/median.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

namespace {

/// Returns half the distance from a point of the boundary across the crack in a direction. A ball that touches the
/// point shrinks until nothing is in it.
double half_width_at(const TriangleBVH& tree, const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                     double radius) {
  constexpr double touching = 1e-9;
  constexpr double inside = 1 - 1e-6;
  constexpr int max_contacts = 64;
  double half_width = 0;
  for (int contact = 0; contact < max_contacts && radius > touching; ++contact) {
    const std::optional<ClosestHit> hit = tree.closest(point + radius * direction, radius);
    if (!hit || !(hit->distance < inside * radius)) return half_width;
    const Eigen::Vector3d across = hit->point - point;
    half_width = across.norm() / 2;
    radius = across.squaredNorm() / (2 * across.dot(direction));
  }
  return 0;
}

/// Computes half the width of the widest crack of a mesh that is narrower than `widest`: the largest half distance from
/// a boundary edge, across a crack, to the surface beyond. A crack is where a ball that touches the edge, in the plane
/// of its triangle, meets other parts of the surface. 0 if there is none. `tree` is that of the mesh, whose coordinates
/// are of the order of 1. Surfaces nearer than about 1e-6 of their triangles' size count as touching.
double half_crack_width(const Shape& mesh, const TriangleBVH& tree, double widest) {
  std::vector<HalfEdge> boundary;
  const std::vector<HalfEdge> uses = surface_half_edges(mesh, welding_of(mesh));
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) boundary.push_back(edge.front());
  });
  std::vector<double> widths(boundary.size());
  parallel_for(std::size_t{0}, boundary.size(), [&](std::size_t i) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return mesh.vertices.row(mesh.triangles(boundary[i].triangle, (boundary[i].corner + k) % 3)).transpose();
    };
    const Eigen::Vector3d begin = corner(0);
    const Eigen::Vector3d along = (corner(1) - begin).normalized();
    const Eigen::Vector3d back = corner(2) - begin;
    const Eigen::Vector3d outwards = -(back - along.dot(back) * along).normalized();
    for (const Eigen::Vector3d& point : {begin, Eigen::Vector3d((begin + corner(1)) / 2), corner(1)}) {
      widths[i] = std::max(widths[i], half_width_at(tree, point, outwards, widest / 2));
    }
  });
  return widths.empty() ? 0 : std::ranges::max(widths);
}

/// Returns the distance within which this fraction of the points have their sixth neighbour.
double sixth_neighbour_distance(const Points& points, double fraction) {
  std::vector<double> distances = distances_to_sixth_neighbour(points);
  return lower_quantile(distances, fraction);
}

/// Distances to a shape of unit diagonal at the nodes of a grid around it.
class DistanceGrid {
 public:
  explicit DistanceGrid(const Shape& unit_shape) : tree_(unit_shape) {
    constexpr double margin = 0.02;
    constexpr double nodes = 200'000;
    constexpr double smallest_cell = 1.0 / 400;  // for flat shapes
    const Eigen::AlignedBox3d box = bounding_box(unit_shape);
    const Eigen::Array3d sizes = box.sizes().array() + 2 * margin;
    cell_ = std::max(std::cbrt(sizes.prod() / nodes), smallest_cell);
    counts_ = (sizes / cell_).ceil().cast<std::int32_t>() + 1;
    origin_ = box.center().array() - 0.5 * cell_ * (counts_ - 1).cast<double>();
    distances_.resize(static_cast<std::size_t>(counts_.prod()));
    parallel_for(std::int32_t{0}, counts_[1] * counts_[2], [&](std::int32_t row) {
      std::int32_t hint = -1;
      for (std::int32_t node = row * counts_[0]; node < (row + 1) * counts_[0]; ++node) {
        const std::optional<ClosestHit> hit = tree_.closest(position(node), unlimited, hint);
        hint = hit->triangle;
        distances_[static_cast<std::size_t>(node)] = hit->distance;
      }
    });
  }

  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(distances_.size()); }
  [[nodiscard]] double cell() const { return cell_; }
  [[nodiscard]] const TriangleBVH& tree() const { return tree_; }
  [[nodiscard]] double distance(std::int32_t node) const { return distances_[static_cast<std::size_t>(node)]; }

  [[nodiscard]] bool on_border(std::int32_t node) const {
    const Eigen::Array3i at = coordinates(node);
    return (at == 0 || at == counts_ - 1).any();
  }

  /// Returns the six neighbours of a node that is not on the border: two along each axis.
  [[nodiscard]] std::array<std::int32_t, 6> neighbours(std::int32_t node) const {
    const std::int32_t layer = counts_[0] * counts_[1];
    return {node - 1, node + 1, node - counts_[0], node + counts_[0], node - layer, node + layer};
  }

  /// Returns the largest distance to the shape near a node, in the plane across an axis: the radius of a passage along
  /// the axis.
  [[nodiscard]] double radius_across(std::int32_t node, std::size_t axis) const {
    Eigen::Vector3d best = position(node);
    double radius = distance(node);
    for (const double step : {cell_ / 2, cell_ / 4, cell_ / 8, cell_ / 16}) {
      for (const double side : {-step, step, -step, step}) {
        for (const std::size_t across : {(axis + 1) % 3, (axis + 2) % 3}) {
          const Eigen::Vector3d moved = best + side * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(across));
          const double distance = tree_.closest(moved)->distance;
          if (distance <= radius) continue;
          radius = distance;
          best = moved;
        }
      }
    }
    return radius;
  }

 private:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  [[nodiscard]] Eigen::Array3i coordinates(std::int32_t node) const {
    return {node % counts_[0], node / counts_[0] % counts_[1], node / counts_[0] / counts_[1]};
  }
  [[nodiscard]] Eigen::Vector3d position(std::int32_t node) const {
    return origin_ + cell_ * coordinates(node).cast<double>();
  }

  TriangleBVH tree_;
  double cell_ = 0;
  Eigen::Array3i counts_;
  Eigen::Array3d origin_;
  std::vector<double> distances_;
};

/// Adds the nodes of a grid in the order of falling distances, and notes where the outside meets an inner space: the
/// distance there is the radius of the widest passage between them (0-dimensional persistence of the superlevel sets).
class Flood {
 public:
  explicit Flood(const DistanceGrid& grid)
      : grid_(grid), parent_(static_cast<std::size_t>(grid.size()), dry), nodes_(parent_.size(), 1) {
    std::vector<std::int32_t> order;
    for (std::int32_t node = 0; node < grid.size(); ++node) {
      if (grid.on_border(node)) {
        parent(node) = outside;
      } else {
        order.push_back(node);
      }
    }
    std::ranges::sort(order, {}, [&](std::int32_t node) { return std::pair(-grid.distance(node), node); });
    for (const std::int32_t node : order) add(node);
  }

  /// Returns the radii of the gaps between inner spaces and the outside.
  [[nodiscard]] std::vector<double> gaps() const { return gaps_; }

  /// Returns true if an inner space is closed, or open only through gaps that the grid does not resolve.
  [[nodiscard]] bool has_sealed_space() const { return sealed_; }

 private:
  static constexpr std::int32_t dry = -1;
  static constexpr std::int32_t outside = 0;     // the first node is on the border
  static constexpr double min_depth = 1.3;       // of an inner space, as a multiple of the gap
  static constexpr std::int32_t min_nodes = 32;  // of an inner space: the grid has pockets near rough surfaces

  std::int32_t& nodes(std::int32_t deepest_node) { return nodes_[static_cast<std::size_t>(deepest_node)]; }
  std::int32_t& parent(std::int32_t node) { return parent_[static_cast<std::size_t>(node)]; }

  /// Returns the deepest node of the space that the node is in.
  std::int32_t deepest(std::int32_t node) {
    while (parent(node) != node) node = parent(node) = parent(parent(node));
    return node;
  }

  void add(std::int32_t node) {
    parent(node) = node;
    const std::array<std::int32_t, 6> neighbours = grid_.neighbours(node);
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
      if (parent(neighbours[i]) == dry) continue;
      const std::int32_t a = deepest(node);
      const std::int32_t b = deepest(neighbours[i]);
      if (a == b) continue;
      if (a == outside || b == outside) note_gap(node, i / 2, a + b - outside);
      const bool a_stays = a == outside || (b != outside && grid_.distance(a) >= grid_.distance(b));
      const std::int32_t joined = a_stays ? a : b;
      const std::int32_t other = a_stays ? b : a;
      parent(other) = joined;
      nodes(joined) += nodes(other);
    }
  }

  /// Notes the gap at a node between the outside and a space.
  void note_gap(std::int32_t node, std::size_t axis, std::int32_t space) {
    const double level = grid_.distance(node);
    const double depth = grid_.distance(space);
    if (depth < min_depth * level || nodes(space) < min_nodes) return;
    if (level > grid_.cell() / 2) {
      gaps_.push_back(std::min(grid_.radius_across(node, axis), depth));
    } else {
      sealed_ = true;  // one of two adjacent nodes on different sides of a wall is within half a cell of it
    }
  }

  const DistanceGrid& grid_;
  std::vector<std::int32_t> parent_;
  std::vector<std::int32_t> nodes_;  ///< by deepest node: size of the space
  std::vector<double> gaps_;
  bool sealed_ = false;
};

/// Returns the radii as fractions of the diagonal.
std::vector<double> gaps_in_diagonals(const Shape& shape) {
  const UnitFrame frame = unit_frame(shape);
  if (!(bounding_box_diagonal(shape) > 0) || !std::isfinite(frame.diagonal)) return {};
  const Shape unit_shape = in_unit_frame(without_duplicates(shape), frame);
  const DistanceGrid grid(unit_shape);
  const Flood flood(grid);
  std::vector<double> gaps = flood.gaps();
  if (flood.has_sealed_space() && !is_cloud(shape)) {
    gaps.push_back(half_crack_width(unit_shape, grid.tree(), grid.cell()));
  }
  return gaps;
}

}  // namespace

GapSizes gap_sizes(const Shape& shape) {
  require_usable(shape);
  if (is_closed(shape)) return {};
  GapSizes sizes;
  const double diagonal = bounding_box_diagonal(shape);
  for (const double gap : gaps_in_diagonals(shape)) {
    sizes.widest = std::max(sizes.widest, gap * diagonal);
    if (offset_per_gap * gap <= largest_automatic_offset) sizes.closable = std::max(sizes.closable, gap * diagonal);
  }
  if (!is_cloud(shape) || shape.vertices.rows() == 0) return sizes;
  const double spacing = sixth_neighbour_distance(shape.vertices, 0.999);
  return {std::max(sizes.widest, spacing), std::max(sizes.closable, spacing)};
}

double point_spacing(const Shape& shape) {
  require_usable(shape);
  return is_cloud(shape) && shape.vertices.rows() > 0 ? sixth_neighbour_distance(shape.vertices, 0.5) : 0;
}

}  // namespace shapegauge
