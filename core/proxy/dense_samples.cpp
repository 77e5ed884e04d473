// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/proxy/dense_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/spatial/morton_order.h"

namespace shapegauge {

namespace {

/// Triangle with its corners in ascending order of coordinates, which makes results independent of the order in the
/// file and of the orientation.
struct CanonicalTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  Eigen::Vector3d normal;  ///< times twice the area
  bool reversed;           ///< the corners are an odd permutation of the mesh's
};

auto coordinates_of(const Eigen::Vector3d& p) { return std::tuple(p.x(), p.y(), p.z()); }

CanonicalTriangle canonical_triangle(const Shape& mesh, Eigen::Index triangle) {
  CanonicalTriangle result{{}, {}, false};
  auto& corners = result.corners;
  for (int k = 0; k < 3; ++k) corners[k] = mesh.vertices.row(mesh.triangles(triangle, k)).transpose();
  const auto order = [&](int a, int b) {
    if (!(coordinates_of(corners[b]) < coordinates_of(corners[a]))) return;
    std::swap(corners[a], corners[b]);
    result.reversed = !result.reversed;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  result.normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  return result;
}

/// Consistent orientation of triangles across edges with exactly two of them.
struct TriangleSheets {
  std::vector<std::int32_t> sheet;  ///< per triangle; -1 in a non-orientable piece
  std::vector<char> reversed;       ///< per triangle: reversed relative to the sheet
};

struct AdjacentTriangle {
  std::int32_t triangle;
  std::int32_t to;
  bool opposed;  ///< the two traverse their edge in the same direction
};

BucketSorted<AdjacentTriangle> adjacent_triangles(std::span<const HalfEdge> uses, std::size_t triangles) {
  std::vector<AdjacentTriangle> pairs;
  pairs.reserve(uses.size());
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2) return;
    const bool opposed = edge[0].forward == edge[1].forward;
    pairs.push_back({edge[0].triangle, edge[1].triangle, opposed});
    pairs.push_back({edge[1].triangle, edge[0].triangle, opposed});
  });
  return bucket_sort(pairs, triangles, [](const AdjacentTriangle& pair) { return pair.triangle; });
}

TriangleSheets triangle_sheets(std::span<const HalfEdge> uses, std::size_t triangles) {
  const BucketSorted<AdjacentTriangle> adjacent = adjacent_triangles(uses, triangles);
  constexpr std::int32_t unseen = -2;
  TriangleSheets result{std::vector<std::int32_t>(triangles, unseen), std::vector<char>(triangles, 0)};
  std::vector<std::int32_t> piece;
  const SparseInterruptionCheck check;
  for (std::size_t seed = 0; seed < triangles; ++seed) {
    if (result.sheet[seed] != unseen) continue;
    const auto sheet = static_cast<std::int32_t>(seed);
    bool orientable = true;
    piece.assign(1, sheet);
    result.sheet[seed] = sheet;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      check();
      const auto from = static_cast<std::size_t>(piece[next]);
      for (std::size_t k = adjacent.first[from]; k < adjacent.first[from + 1]; ++k) {
        const AdjacentTriangle& pair = adjacent.values[k];
        const auto to = static_cast<std::size_t>(pair.to);
        const char reversed = static_cast<char>((result.reversed[from] != 0) != pair.opposed);
        if (result.sheet[to] == unseen) {
          result.sheet[to] = sheet;
          result.reversed[to] = reversed;
          piece.push_back(pair.to);
        } else if (result.reversed[to] != reversed) {
          orientable = false;
        }
      }
    }
    if (orientable) continue;
    for (const std::int32_t triangle : piece) result.sheet[static_cast<std::size_t>(triangle)] = -1;
  }
  return result;
}

/// Returns the first of each set of duplicate triangles, along a Morton curve of their centroids.
std::vector<std::int32_t> ordered_triangles(std::span<const HalfEdge> uses,
                                            const std::vector<CanonicalTriangle>& triangles) {
  std::vector<char> counts(triangles.size(), 0);
  for (const HalfEdge& use : uses) counts[static_cast<std::size_t>(use.triangle)] = 1;
  std::vector<std::int32_t> order;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const double twice_area = triangles[t].normal.norm();
    if (counts[t] != 0 && std::isnormal(twice_area)) order.push_back(static_cast<std::int32_t>(t));
  }
  Points centroids(std::ssize(order), 3);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& corners = triangles[static_cast<std::size_t>(order[i])].corners;
    centroids.row(static_cast<Eigen::Index>(i)) = ((corners[0] + corners[1] + corners[2]) / 3).transpose();
  }
  struct SortKey {
    std::uint64_t code;
    std::int32_t triangle;
  };
  std::vector<SortKey> keys(order.size());
  const std::vector<std::uint64_t> codes = morton_codes(centroids);
  for (std::size_t i = 0; i < order.size(); ++i) keys[i] = {codes[i], order[i]};
  const auto corners_of = [&](const SortKey& key) {
    const auto& corners = triangles[static_cast<std::size_t>(key.triangle)].corners;
    return std::tuple(coordinates_of(corners[0]), coordinates_of(corners[1]), coordinates_of(corners[2]));
  };
  std::ranges::sort(keys, [&](const SortKey& a, const SortKey& b) {
    return a.code != b.code ? a.code < b.code : corners_of(a) < corners_of(b);
  });
  std::ranges::transform(keys, order.begin(), &SortKey::triangle);
  return order;
}

/// Returns the k-th point of a low-discrepancy sequence on the triangle (Roberts 2018, the R2 sequence, folded at the
/// diagonal).
Eigen::RowVector3d point_in(const CanonicalTriangle& triangle, Eigen::Index k) {
  double u = std::fmod(0.7548776662466927 * static_cast<double>(k + 1), 1.0);
  double v = std::fmod(0.5698402909980532 * static_cast<double>(k + 1), 1.0);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const auto& [a, b, c] = triangle.corners;
  return (a + u * (b - a) + v * (c - a)).transpose();
}

DenseSamples dense_samples_of_mesh(const Shape& mesh, std::span<const HalfEdge> uses, Eigen::Index count) {
  const TriangleSheets sheets = triangle_sheets(uses, static_cast<std::size_t>(mesh.triangles.rows()));
  std::vector<CanonicalTriangle> triangles;
  triangles.reserve(sheets.sheet.size());
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) triangles.push_back(canonical_triangle(mesh, t));
  const std::vector<std::int32_t> order = ordered_triangles(uses, triangles);
  double total = 0;
  for (const std::int32_t t : order) total += triangles[static_cast<std::size_t>(t)].normal.norm() / 2;
  if (!std::isnormal(total))
    throw InputError("a surface proxy needs a triangle of positive area, and the mesh has none");
  DenseSamples samples{Points(count, 3), Points(count, 3),
                       Eigen::VectorXd::Constant(count, total / static_cast<double>(count)),
                       std::vector<std::int32_t>(static_cast<std::size_t>(count)),
                       std::vector<std::int32_t>(static_cast<std::size_t>(count))};
  double covered = 0;
  Eigen::Index i = 0;
  for (std::size_t k = 0; k < order.size() && i < count; ++k) {
    const auto t = static_cast<std::size_t>(order[k]);
    const CanonicalTriangle& triangle = triangles[t];
    covered += triangle.normal.norm() / 2;
    const bool last = k + 1 == order.size();
    const bool turned = triangle.reversed != (sheets.reversed[t] != 0);
    const Eigen::RowVector3d normal = (turned ? -1.0 : 1.0) * triangle.normal.normalized().transpose();
    for (; i < count && (last || (static_cast<double>(i) + 0.5) * total < covered * static_cast<double>(count)); ++i) {
      samples.points.row(i) = point_in(triangle, i);
      samples.normals.row(i) = normal;
      samples.sheets[static_cast<std::size_t>(i)] = sheets.sheet[t];
      samples.triangles[static_cast<std::size_t>(i)] = order[k];
    }
  }
  return samples;
}

/// Returns at most `count` distinct points of a cloud along a Morton curve.
std::vector<std::int32_t> ordered_points(const Points& points, Eigen::Index count) {
  const std::vector<std::uint64_t> codes = morton_codes(points);
  const auto coordinates = [&](std::int32_t i) { return std::tuple(points(i, 0), points(i, 1), points(i, 2)); };
  std::vector<std::int32_t> order(codes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const std::uint64_t of_a = codes[static_cast<std::size_t>(a)];
    const std::uint64_t of_b = codes[static_cast<std::size_t>(b)];
    return of_a != of_b ? of_a < of_b : std::tuple(coordinates(a), a) < std::tuple(coordinates(b), b);
  });
  const auto same_position = [&](std::int32_t a, std::int32_t b) { return points.row(a) == points.row(b); };
  order.erase(std::unique(order.begin(), order.end(), same_position), order.end());
  const auto max_size = static_cast<std::size_t>(count);
  if (order.size() <= max_size) return order;
  for (std::size_t i = 0; i < max_size; ++i) order[i] = order[(2 * i + 1) * order.size() / (2 * max_size)];
  order.resize(max_size);
  return order;
}

DenseSamples dense_samples_of_cloud(const Shape& cloud, Eigen::Index count) {
  const std::vector<std::int32_t> order = ordered_points(cloud.vertices, count);
  DenseSamples samples;
  samples.points = cloud.vertices(order, Eigen::all);
  samples.areas = point_weights(samples.points);
  if (!(samples.areas.sum() > 0)) throw InputError("a surface proxy needs at least two distinct points");
  samples.normals = unsigned_point_normals(samples.points);
  samples.sheets.assign(order.size(), -1);
  return samples;
}

}  // namespace

bool on_same_sheet(const DenseSamples& samples, std::int32_t i, std::int32_t j, double distance) {
  constexpr double min_agreement = -0.3;  // sharp edges are passed, the rim of a thin wall is not
  constexpr double tolerance = 0.2;
  const double agreement = normal_agreement(samples, i, j);
  const Eigen::RowVector3d direction = (samples.points.row(j) - samples.points.row(i)) / distance;
  const double off_i = direction.dot(samples.normals.row(i));
  const double off_j = direction.dot(samples.normals.row(j));
  return agreement > min_agreement && off_i * off_i + off_j * off_j < 1 - agreement + tolerance;
}

DenseSamples dense_samples(const Shape& shape, std::span<const HalfEdge> uses, Eigen::Index count) {
  return is_cloud(shape) ? dense_samples_of_cloud(shape, count) : dense_samples_of_mesh(shape, uses, count);
}

}  // namespace shapegauge
