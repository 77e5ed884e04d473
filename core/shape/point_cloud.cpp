// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/shape/point_cloud.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <limits>
#include <nanoflann.hpp>
#include <numbers>
#include <numeric>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/median.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/parallel_parts.h"
#include "shapegauge/core/spatial/morton_order.h"

namespace shapegauge {

namespace {

/// Adapts points to nanoflann. Building a tree can be interrupted.
struct PointSource {
  Points points;
  bool building = true;  ///< in one thread; queries run in many and do not check
  SparseInterruptionCheck check{};

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points.rows()); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    if (building) check();
    return points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(axis));
  }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;  // the tree finds it
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointSource>, PointSource, 3,
                                                 std::int32_t>;

/// Tree of points with its source.
struct PointTree {
  explicit PointTree(const Points& points) : source{points}, tree(3, source) { source.building = false; }
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;
  PointTree(PointTree&&) = delete;
  PointTree& operator=(PointTree&&) = delete;
  ~PointTree() = default;

  PointSource source;
  Tree tree;
};

/// Scratch buffers for one query, including the point itself.
struct Query {
  explicit Query(std::size_t count) : indices(count), squared_distances(count) {}
  std::vector<std::int32_t> indices;
  std::vector<double> squared_distances;
};

void find(const PointTree& built, const Points& points, Eigen::Index i, Query& query, PointNeighbours& result) {
  built.tree.knnSearch(points.row(i).data(), query.indices.size(), query.indices.data(),
                       query.squared_distances.data());
  // If too many points coincide and the point itself is not among those found, drops the last one.
  const auto self = std::find(query.indices.begin(), query.indices.end() - 1, static_cast<std::int32_t>(i));
  std::int32_t* const indices = std::copy(query.indices.begin(), self, result.indices.row(i).data());
  std::copy(self + 1, query.indices.end(), indices);
  for (Eigen::Index k = 0; k < result.distances.cols(); ++k) {
    const Eigen::Index skipped = k < self - query.indices.begin() ? 0 : 1;
    result.distances(i, k) = std::sqrt(query.squared_distances[static_cast<std::size_t>(k + skipped)]);
  }
}

// Order of queries in which consecutive ones use the same parts of a tree.
std::vector<std::int32_t> query_order(const Points& points) {
  if (points.allFinite()) return morton_order(points);
  std::vector<std::int32_t> order(static_cast<std::size_t>(points.rows()));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

// More neighbours reach around corners and through thin parts. On a regular grid whole shells have the same distance:
// single numbers of neighbours err by up to a third, their mean by a tenth.
constexpr Eigen::Index min_neighbours = 5;
constexpr Eigen::Index max_neighbours = 12;
// 4 is beyond noise: fewer than 2 in 10,000 points of a surface, random or from a mesh, exceed it.
constexpr double largest_ratio = 4;

/// Distinct positions of points, in an order that depends on the positions only.
struct DistinctPoints {
  Points points;
  std::vector<Eigen::Index> index_of;  ///< per original point: index in `points`
  std::vector<Eigen::Index> counts;    ///< number of original points at each distinct position
};

DistinctPoints distinct_points(const Points& points) {
  const SparseInterruptionCheck check;
  const auto coordinates = [&](Eigen::Index i) {
    check();
    return std::array{points(i, 0), points(i, 1), points(i, 2)};
  };
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::sort(order, {}, coordinates);
  DistinctPoints distinct{Points(points.rows(), 3), std::vector<Eigen::Index>(order.size()),
                          std::vector<Eigen::Index>(order.size())};
  Eigen::Index count = 0;
  for (const Eigen::Index i : order) {
    if (count == 0 || distinct.points.row(count - 1) != points.row(i)) distinct.points.row(count++) = points.row(i);
    distinct.index_of[static_cast<std::size_t>(i)] = count - 1;
    ++distinct.counts[static_cast<std::size_t>(count - 1)];
  }
  distinct.points.conservativeResize(count, 3);
  return distinct;
}

void require_finite(const Points& points, double diagonal) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) {
      throw InputError(fmt::format("point {} has a coordinate that is not a finite number", i));
    }
  }
  if (!std::isfinite(diagonal))
    throw InputError("the coordinates are too large: the diagonal of the bounding box is not a finite number");
}

/// Returns the mean over k of pi d^2 / k, where d is the distance to the k-th neighbour.
Eigen::VectorXd disc_areas(const PointNeighbours& nearest) {
  const Eigen::Index most = nearest.distances.cols();
  const Eigen::Index fewest = std::min(min_neighbours, most);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(nearest.distances.rows());
  for (Eigen::Index k = fewest; k <= most; ++k) {
    sum += nearest.distances.col(k - 1).cwiseAbs2() / static_cast<double>(k);
  }
  return std::numbers::pi * sum / static_cast<double>(most - fewest + 1);
}

/// Limits each weight to `largest_ratio` times the median of its neighbours'.
Eigen::VectorXd capped(const Eigen::VectorXd& weights, const PointNeighbours& nearest) {
  Eigen::VectorXd result = weights;
  std::vector<double> around(static_cast<std::size_t>(nearest.indices.cols()));
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    for (std::size_t k = 0; k < around.size(); ++k) {
      around[k] = weights[nearest.indices(i, static_cast<Eigen::Index>(k))];
    }
    result[i] = std::min(weights[i], largest_ratio * upper_median(around));
  }
  return result;
}

constexpr Eigen::Index normal_neighbours = 12;
/// A neighbour farther from the plane than this part of the distance to the farthest neighbour is not on it.
constexpr double normal_tolerance = 0.2;

/// Neighbours of a point relative to it, the farthest at a distance of 1.
using NormalNeighbourhood = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, normal_neighbours + 1, 3>;

/// Returns the normal of the plane through the point and two of its neighbours to which all neighbours are closest: the
/// sum of their distances, each at most the tolerance, is minimal. Zero if no two span a plane.
Eigen::Vector3d closest_plane(const NormalNeighbourhood& around) {
  constexpr float min_sine = 0.3F;
  using Lanes = Eigen::Array<float, 16, 1>;  // in single precision, to compute the distances of all at once
  std::array<Lanes, 3> coordinates{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    coordinates[static_cast<std::size_t>(axis)].head(around.rows()) = around.col(axis).cast<float>().array();
  }
  const auto& [x, y, z] = coordinates;
  float min_cost = std::numeric_limits<float>::infinity();
  Eigen::Vector3f closest = Eigen::Vector3f::Zero();
  for (Eigen::Index a = 0; a + 1 < around.rows(); ++a) {
    const Eigen::Vector3f u(x[a], y[a], z[a]);
    for (Eigen::Index b = a + 1; b + 1 < around.rows(); ++b) {
      const Eigen::Vector3f v(x[b], y[b], z[b]);
      const Eigen::Vector3f cross = u.cross(v);
      const float squared = cross.squaredNorm();
      if (!(squared > min_sine * min_sine * u.squaredNorm() * v.squaredNorm())) continue;
      const Eigen::Vector3f normal = cross / std::sqrt(squared);
      const Lanes distances = (normal.x() * x + normal.y() * y + normal.z() * z).abs();
      const float cost = distances.min(static_cast<float>(normal_tolerance)).sum();
      if (!(cost < min_cost)) continue;
      min_cost = cost;
      closest = normal;
    }
  }
  return closest.cast<double>();
}

/// Fits a plane to the points near a plane through the origin, and again to those near the fitted one: least squares
/// weighted by the distances from the plane before (Tukey's biweight). Weights are equal if the given normal is zero.
Eigen::Vector3d fitted_normal(const NormalNeighbourhood& around, Eigen::Vector3d normal) {
  constexpr int rounds = 3;
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
  for (int round = 0; round < rounds; ++round) {
    const Eigen::Array<double, Eigen::Dynamic, 1, 0, normal_neighbours + 1, 1> relative =
        ((around.rowwise() - mean) * normal).array() / normal_tolerance;
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, normal_neighbours + 1, 1> weights =
        (1 - relative.square()).max(0.0).square().matrix();
    if (!(weights.sum() > 0)) break;
    mean = weights.transpose() * around / weights.sum();
    const NormalNeighbourhood centred = around.rowwise() - mean;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(centred.transpose() * weights.asDiagonal() * centred);
    normal = solver.eigenvectors().col(0);
  }
  return normal;
}

}  // namespace

PointNeighbours nearest_neighbours(const Points& points, Eigen::Index k) {
  const Eigen::Index n = points.rows();
  k = std::clamp<Eigen::Index>(k, 0, std::max<Eigen::Index>(n - 1, 0));
  PointNeighbours result;
  result.indices.resize(n, k);
  result.distances.resize(n, k);
  if (k == 0) return result;
  const PointTree built(points);
  const std::vector<std::int32_t> order = query_order(points);
  interruptible_parallel_for(tbb::blocked_range<std::size_t>(0, order.size(), 256), [&](const auto& block) {
    Query query(static_cast<std::size_t>(k + 1));
    for (std::size_t index = block.begin(); index != block.end(); ++index) {
      find(built, points, order[index], query, result);
    }
  });
  return result;
}

PointNeighbours nearest_among(const Points& points, const Points& among, Eigen::Index k) {
  k = std::min(k, among.rows());
  PointNeighbours result;
  result.indices.resize(points.rows(), k);
  result.distances.resize(points.rows(), k);
  if (k == 0) return result;
  const PointTree built(among);
  const std::vector<std::int32_t> order = query_order(points);
  interruptible_parallel_for(tbb::blocked_range<std::size_t>(0, order.size(), 256), [&](const auto& block) {
    for (std::size_t index = block.begin(); index != block.end(); ++index) {
      const std::int32_t i = order[index];
      built.tree.knnSearch(points.row(i).data(), static_cast<std::size_t>(k), result.indices.row(i).data(),
                           result.distances.row(i).data());
    }
  });
  result.distances = result.distances.cwiseSqrt();
  return result;
}

std::vector<std::int32_t> nearest_points(const Points& points, const Points& among) {
  const auto nearest = nearest_among(points, among, 1).indices;
  return {nearest.data(), nearest.data() + nearest.size()};
}

std::vector<double> distances_to_sixth_neighbour(const Points& points) {
  constexpr Eigen::Index neighbours = 6;
  std::vector<double> distances(static_cast<std::size_t>(points.rows()));
  if (distances.size() < 2) return distances;
  Eigen::Map<Eigen::VectorXd>(distances.data(), points.rows()) =
      nearest_neighbours(points, neighbours).distances.rightCols(1);
  return distances;
}

Points unsigned_point_normals(const Points& points) {
  const PointNeighbours nearest = nearest_neighbours(points, normal_neighbours);
  Points normals = Points::Zero(points.rows(), 3);
  parallel_for(Eigen::Index{0}, points.rows(), [&](Eigen::Index i) {
    // Relative to the farthest neighbour, to avoid overflow and underflow of products.
    const Eigen::Index count = nearest.indices.cols();
    const double reach = count > 0 ? nearest.distances(i, count - 1) : 0;
    if (!(reach > 0)) return;
    NormalNeighbourhood around = NormalNeighbourhood::Zero(count + 1, 3);  // the last row is the point itself
    for (Eigen::Index k = 0; k < count; ++k) {
      around.row(k) = (points.row(nearest.indices(i, k)) - points.row(i)) / reach;
    }
    normals.row(i) = fitted_normal(around, closest_plane(around)).transpose();
  });
  return normals;
}

Eigen::VectorXd point_weights(const Points& points) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(points.rows());
  const UnitFrame frame = unit_frame({points, {}, {}});
  require_finite(points, frame.diagonal);
  DistinctPoints distinct = distinct_points(points);
  if (distinct.points.rows() < 2) return weights;
  // With coordinates near 1, squares neither underflow nor overflow.
  for (Eigen::Index i = 0; i < distinct.points.rows(); ++i) {
    distinct.points.row(i) = frame.to_unit(distinct.points.row(i).transpose()).transpose();
  }
  const PointNeighbours nearest = nearest_neighbours(distinct.points, max_neighbours);
  const Eigen::VectorXd areas = capped(disc_areas(nearest), nearest);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Index index = distinct.index_of[static_cast<std::size_t>(i)];
    const auto sharing = static_cast<double>(distinct.counts[static_cast<std::size_t>(index)]);
    weights[i] = areas[index] / sharing * frame.diagonal * frame.diagonal;
  }
  return weights;
}

}  // namespace shapegauge
