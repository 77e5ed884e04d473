// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/spatial/triangle_bvh_layout.h"

namespace shapegauge {

namespace {

using Box = Eigen::AlignedBox3d;
constexpr int bin_count = 16;
/// Margin of the single-precision boxes around the triangles, relative to their coordinates.
constexpr double box_margin = 1e-6;

Box box_of(const Triangle& triangle) {
  Box box(triangle.a);
  box.extend(triangle.b);
  box.extend(triangle.c);
  return box;
}

double half_area(const Box& box) {
  if (box.isEmpty()) return 0;
  const Eigen::Vector3d size = box.sizes();
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

/// Builds the nodes over recursively divided spans of one array of triangle indices.
class Builder {
 public:
  Builder(std::vector<TriangleBvhNode>& nodes, std::vector<TriangleBvhLeaf>& leaves,
          const std::vector<Triangle>& triangles)
      : nodes_(nodes), leaves_(leaves), triangles_(triangles), order_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    boxes_.reserve(triangles.size());
    crosses_.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
      boxes_.push_back(box_of(triangle));
      crosses_.emplace_back((triangle.b - triangle.a).cross(triangle.c - triangle.a));
    }
  }

  void build() {
    leaves_.reserve(2 * order_.size() / triangles_per_leaf + 1);  // most are more than half full
    add_node(std::span(order_));
  }

 private:
  using Part = std::span<std::int32_t>;

  [[nodiscard]] Box box_of_part(Part part) const {
    Box box;
    for (const std::int32_t i : part) box.extend(boxes_[static_cast<std::size_t>(i)]);
    return box;
  }

  [[nodiscard]] Eigen::Vector3d centre(std::int32_t i) const { return boxes_[static_cast<std::size_t>(i)].center(); }

  /// Splits a part in two along the axis of largest extent of its centres by the surface area heuristic, or in the
  /// middle if that fails.
  [[nodiscard]] std::pair<Part, Part> split(Part part) const {
    Box centres;
    for (const std::int32_t i : part) centres.extend(centre(i));
    Eigen::Index axis = 0;
    const double extent = centres.sizes().maxCoeff(&axis);
    if (extent > 0) {
      const double low = centres.min()[axis];
      const auto bin_of = [&](std::int32_t i) {
        return std::min(bin_count - 1, static_cast<int>(bin_count * ((centre(i)[axis] - low) / extent)));
      };
      const int bin = best_bin(part, bin_of);
      const auto middle = std::partition(part.begin(), part.end(), [&](std::int32_t i) { return bin_of(i) < bin; });
      const auto count = static_cast<std::size_t>(middle - part.begin());
      if (count > 0 && count < part.size()) return {part.first(count), part.subspan(count)};
    }
    return {part.first(part.size() / 2), part.subspan(part.size() / 2)};
  }

  template <typename BinOf>
  [[nodiscard]] int best_bin(Part part, const BinOf& bin_of) const {
    std::array<Box, bin_count> boxes;
    std::array<double, bin_count> counts{};
    for (const std::int32_t i : part) {
      const auto bin = static_cast<std::size_t>(bin_of(i));
      boxes[bin].extend(boxes_[static_cast<std::size_t>(i)]);
      ++counts[bin];
    }
    std::array<double, bin_count> cost{};
    Box left;
    double count = 0;
    for (std::size_t bin = 1; bin < bin_count; ++bin) {
      left.extend(boxes[bin - 1]);
      count += counts[bin - 1];
      cost[bin] = half_area(left) * count;
    }
    Box right;
    count = 0;
    int best = bin_count / 2;
    double best_cost = std::numeric_limits<double>::infinity();
    for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
      right.extend(boxes[bin]);
      count += counts[bin];
      cost[bin] += half_area(right) * count;
      if (cost[bin] < best_cost) {
        best_cost = cost[bin];
        best = static_cast<int>(bin);
      }
    }
    return best;
  }

  /// Splits the largest parts until there are eight or all fit into leaves.
  [[nodiscard]] std::vector<Part> split_in_eight(Part whole) const {
    std::vector<Part> parts{whole};
    while (parts.size() < children_per_node) {
      const auto largest = std::max_element(parts.begin(), parts.end(),
                                            [](const Part& x, const Part& y) { return x.size() < y.size(); });
      if (largest->size() <= triangles_per_leaf) break;
      const auto [left, right] = split(*largest);
      *largest = left;
      parts.push_back(right);
    }
    return parts;
  }

  std::int32_t add_node(Part part) {
    check_interruption();
    const auto index = nodes_.size();
    nodes_.emplace_back();
    const std::vector<Part> parts = split_in_eight(part);
    for (std::size_t i = 0; i < children_per_node; ++i) {
      set_box(index, i, i < parts.size() ? box_of_part(parts[i]) : Box());
      if (i < parts.size()) set_disk(index, i, parts[i]);
      std::int32_t child = 0;
      if (i < parts.size()) child = parts[i].size() <= triangles_per_leaf ? add_leaf(parts[i]) : add_node(parts[i]);
      nodes_[index].child[i] = child;
    }
    return static_cast<std::int32_t>(index);
  }

  void set_box(std::size_t node, std::size_t child, const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      float low = std::numeric_limits<float>::infinity();
      float high = -low;
      if (!box.isEmpty()) {
        const auto axis = static_cast<Eigen::Index>(k);
        const double margin = box_margin * (1 + std::max(std::abs(box.min()[axis]), std::abs(box.max()[axis])));
        low = static_cast<float>(box.min()[axis] - margin);
        high = static_cast<float>(box.max()[axis] + margin);
      }
      nodes_[node].low[k][child] = low;
      nodes_[node].high[k][child] = high;
    }
  }

  /// Returns the mean normal of triangles, each turned to the side of those before it; zero if all are degenerate.
  [[nodiscard]] Eigen::Vector3d mean_normal(Part part) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::int32_t i : part) {
      const Eigen::Vector3d& cross = crosses_[static_cast<std::size_t>(i)];
      sum += cross.dot(sum) < 0 ? Eigen::Vector3d(-cross) : cross;
    }
    return sum.stableNormalized();
  }

  template <typename Visit>
  void for_each_corner(Part part, const Visit& visit) const {
    for (const std::int32_t i : part) {
      const auto& [a, b, c] = triangles_[static_cast<std::size_t>(i)];
      for (const Eigen::Vector3d* corner : {&a, &b, &c}) visit(*corner);
    }
  }

  /// Returns the maximum length of the difference between unit normals of triangles, turned to the same side, and
  /// another.
  [[nodiscard]] double normal_deviation(Part part, const Eigen::Vector3d& normal) const {
    double square = 0;
    for (const std::int32_t i : part) {
      const Eigen::Vector3d unit_normal = crosses_[static_cast<std::size_t>(i)].stableNormalized();
      if (unit_normal.isZero(0)) continue;
      square = std::max(square, std::min((unit_normal - normal).squaredNorm(), (unit_normal + normal).squaredNorm()));
    }
    return std::sqrt(square);
  }

  void set_disk(std::size_t node, std::size_t child, Part part) {
    const Eigen::Vector3f normal_single = mean_normal(part).cast<float>();
    const Eigen::Vector3d normal = normal_single.cast<double>();
    const Eigen::Vector3d middle = box_of_part(part).center();
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for_each_corner(part, [&](const Eigen::Vector3d& corner) {
      const double along = normal.dot(corner - middle);
      low = std::min(low, along);
      high = std::max(high, along);
    });
    const Eigen::Vector3f centre = (middle + (low + high) / 2 * normal).cast<float>();
    double height = 0;
    double radius2 = 0;
    for_each_corner(part, [&](const Eigen::Vector3d& corner) {
      const Eigen::Vector3d from_centre = corner - centre.cast<double>();
      const double along = normal.dot(from_centre);
      height = std::max(height, std::abs(along));
      radius2 = std::max(radius2, (from_centre - along * normal).squaredNorm());
    });
    for (std::size_t k = 0; k < 3; ++k) {
      nodes_[node].normal[k][child] = normal_single[static_cast<Eigen::Index>(k)];
      nodes_[node].centre[k][child] = centre[static_cast<Eigen::Index>(k)];
    }
    const double margin = box_margin * (1 + centre.cast<double>().norm());
    nodes_[node].half_height[child] = static_cast<float>(height + margin);
    nodes_[node].radius[child] = static_cast<float>(std::sqrt(radius2) + margin);
    nodes_[node].normal_deviation[child] = static_cast<float>(normal_deviation(part, normal) + box_margin);
  }

  std::int32_t add_leaf(Part part) {
    TriangleBvhLeaf leaf{};
    leaf.origin = box_of_part(part).center();
    leaf.used_slots = static_cast<std::int32_t>(part.size());
    for (std::size_t lane = 0; lane < triangles_per_leaf; ++lane) {
      const std::int32_t index = part[std::min(lane, part.size() - 1)];
      leaf.triangle[lane] = index;
      set_lane(leaf, lane, triangles_[static_cast<std::size_t>(index)]);
    }
    leaves_.push_back(leaf);
    return ~static_cast<std::int32_t>(leaves_.size() - 1);
  }

  static void set_vector(LeafVector& vectors, std::size_t lane, const Eigen::Vector3d& value) {
    for (std::size_t k = 0; k < 3; ++k) vectors[k][lane] = static_cast<float>(value[static_cast<Eigen::Index>(k)]);
  }

  static float inverse_square(const Eigen::Vector3d& edge) {
    const auto inverse = static_cast<float>(1 / edge.squaredNorm());
    return std::isfinite(inverse) ? inverse : 0;
  }

  static void set_lane(TriangleBvhLeaf& leaf, std::size_t lane, const Triangle& triangle) {
    const Eigen::Vector3d ab = triangle.b - triangle.a;
    const Eigen::Vector3d ac = triangle.c - triangle.a;
    const Eigen::Vector3d cross = ab.cross(ac);
    const double cross2 = cross.squaredNorm();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d dual_b = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    Eigen::Vector3d dual_c = dual_b;
    if (cross2 > 0) {
      normal = cross / std::sqrt(cross2);
      dual_b = ac.cross(cross) / cross2;
      dual_c = cross.cross(ab) / cross2;
    }
    set_vector(leaf.a, lane, triangle.a - leaf.origin);
    set_vector(leaf.ab, lane, ab);
    set_vector(leaf.ac, lane, ac);
    set_vector(leaf.normal, lane, normal);
    set_vector(leaf.dual_b, lane, dual_b);
    set_vector(leaf.dual_c, lane, dual_c);
    leaf.inverse_ab[lane] = inverse_square(ab);
    leaf.inverse_ac[lane] = inverse_square(ac);
    leaf.inverse_bc[lane] = inverse_square(triangle.c - triangle.b);
  }

  std::vector<TriangleBvhNode>& nodes_;
  std::vector<TriangleBvhLeaf>& leaves_;
  const std::vector<Triangle>& triangles_;
  std::vector<std::int32_t> order_;
  std::vector<Box> boxes_;
  std::vector<Eigen::Vector3d> crosses_;  ///< normals of the triangles with twice their areas as lengths
};

}  // namespace

void build_triangle_bvh(std::vector<TriangleBvhNode>& nodes, std::vector<TriangleBvhLeaf>& leaves,
                        const std::vector<Triangle>& triangles) {
  Builder(nodes, leaves, triangles).build();
}

}  // namespace shapegauge
