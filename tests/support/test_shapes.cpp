// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge::test {

namespace {

/// Splits every triangle into four; the midpoints of the edges become vertices.
void subdivide(std::vector<Eigen::Vector3d>& vertices, std::vector<Eigen::Vector3i>& triangles) {
  std::map<std::pair<int, int>, int> midpoints;
  const auto midpoint = [&](int a, int b) {
    const auto [entry, is_new] = midpoints.try_emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
    if (is_new) vertices.emplace_back((vertices[a] + vertices[b]).normalized());
    return entry->second;
  };
  std::vector<Eigen::Vector3i> finer;
  for (const Eigen::Vector3i& t : triangles) {
    const Eigen::Vector3i m(midpoint(t[0], t[1]), midpoint(t[1], t[2]), midpoint(t[2], t[0]));
    finer.insert(finer.end(), {{t[0], m[0], m[2]}, {t[1], m[1], m[0]}, {t[2], m[2], m[1]}, m});
  }
  triangles = std::move(finer);
}

/// Closed surface of revolution about z. The profile (radius, height) begins and ends on the axis, from the lowest
/// point to the highest.
Shape revolved(const std::vector<Eigen::Vector2d>& profile, int around) {
  std::vector<Eigen::Vector3d> vertices = {{0, 0, profile.front().y()}};
  const int rings = static_cast<int>(profile.size()) - 2;
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      vertices.emplace_back(profile[ring].x() * std::cos(angle), profile[ring].x() * std::sin(angle),
                            profile[ring].y());
    }
  }
  vertices.emplace_back(0, 0, profile.back().y());
  const int top = static_cast<int>(vertices.size()) - 1;
  const auto at = [&](int ring, int i) { return 1 + (ring - 1) * around + i % around; };
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < around; ++i) {
    triangles.emplace_back(0, at(1, i + 1), at(1, i));
    for (int ring = 1; ring < rings; ++ring) {
      triangles.emplace_back(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1));
      triangles.emplace_back(at(ring, i), at(ring + 1, i + 1), at(ring + 1, i));
    }
    triangles.emplace_back(at(rings, i), at(rings, i + 1), top);
  }
  return mesh_of(vertices, triangles);
}

}  // namespace

Shape mesh_of(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  Shape shape{Points(std::ssize(vertices), 3), Triangles(std::ssize(triangles), 3)};
  for (std::size_t i = 0; i < vertices.size(); ++i) shape.vertices.row(static_cast<Eigen::Index>(i)) = vertices[i];
  for (std::size_t i = 0; i < triangles.size(); ++i) shape.triangles.row(static_cast<Eigen::Index>(i)) = triangles[i];
  return shape;
}

Shape soup_of(const std::vector<Eigen::Vector3d>& corners) {
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < std::ssize(corners); i += 3) triangles.emplace_back(i, i + 1, i + 2);
  return mesh_of(corners, triangles);
}

Shape rectangle(double width, double height, int nx, int ny) {
  std::vector<Eigen::Vector3d> vertices;
  for (int y = 0; y <= ny; ++y) {
    for (int x = 0; x <= nx; ++x) vertices.emplace_back(width * x / nx, height * y / ny, 0);
  }
  std::vector<Eigen::Vector3i> triangles;
  const auto vertex = [nx](int x, int y) { return y * (nx + 1) + x; };
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      triangles.emplace_back(vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1));
      triangles.emplace_back(vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1));
    }
  }
  return mesh_of(vertices, triangles);
}

Shape sphere(double radius, int subdivisions) {
  const double g = std::numbers::phi;
  std::vector<Eigen::Vector3d> vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                           {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Eigen::Vector3d& vertex : vertices) vertex.normalize();
  std::vector<Eigen::Vector3i> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                            {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                            {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                            {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int i = 0; i < subdivisions; ++i) subdivide(vertices, triangles);
  for (Eigen::Vector3d& vertex : vertices) vertex *= radius;
  return mesh_of(vertices, triangles);
}

Shape box(const Eigen::Vector3d& size, int n) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> triangles;
  std::map<std::array<int, 3>, int> index_of;
  const auto vertex = [&](const std::array<int, 3>& cell) {
    const auto [entry, is_new] = index_of.try_emplace(cell, static_cast<int>(vertices.size()));
    if (is_new) {
      const Eigen::Vector3d unit(cell[0], cell[1], cell[2]);
      vertices.emplace_back((unit / n - Eigen::Vector3d::Constant(0.5)).cwiseProduct(size));
    }
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const auto at = [&](int i, int j) {
        std::array<int, 3> cell = {};
        cell[axis] = side * n;
        // The two axes swap between the sides, so that both sides face outwards.
        cell[(axis + 2 - side) % 3] = i;
        cell[(axis + 1 + side) % 3] = j;
        return vertex(cell);
      };
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
          triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
      }
    }
  }
  return mesh_of(vertices, triangles);
}

Shape capsule(double radius, double length, int around, int rings) {
  std::vector<Eigen::Vector2d> profile;
  for (int end : {-1, 1}) {
    for (int ring = 0; ring <= rings; ++ring) {
      const double angle = std::numbers::pi / 2 * (end < 0 ? ring - rings : ring) / rings;
      profile.emplace_back(radius * std::cos(angle), end * length / 2 + radius * std::sin(angle));
    }
  }
  return revolved(profile, around);
}

Shape torus(double ring, double tube, int around, int along) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> triangles;
  const auto at = [&](int i, int j) { return (i % along) * around + j % around; };
  for (int i = 0; i < along; ++i) {
    const double u = 2 * std::numbers::pi * i / along;
    for (int j = 0; j < around; ++j) {
      const double v = 2 * std::numbers::pi * j / around;
      const double r = ring + tube * std::cos(v);
      vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
      triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return mesh_of(vertices, triangles);
}

Shape joined(const std::vector<Shape>& parts) {
  Shape all;
  for (const Shape& part : parts) {
    const auto first_vertex = static_cast<std::int32_t>(all.vertices.rows());
    const Eigen::Index first_triangle = all.triangles.rows();
    all.vertices.conservativeResize(first_vertex + part.vertices.rows(), 3);
    all.vertices.bottomRows(part.vertices.rows()) = part.vertices;
    all.triangles.conservativeResize(first_triangle + part.triangles.rows(), 3);
    all.triangles.bottomRows(part.triangles.rows()) = part.triangles.array() + first_vertex;
  }
  return all;
}

Shape transformed(const Shape& shape, double scale, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& move) {
  Shape result = shape;
  result.vertices = ((shape.vertices * scale) * rotation.transpose()).rowwise() + move.transpose();
  return result;
}

Shape twisted_band(int around, int half_turns) {
  Shape band;
  const int rows = 2 * around;
  band.vertices.resize(rows, 3);
  band.triangles.resize(rows, 3);
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    const double tilt = half_turns * angle / 2;
    for (int side = 0; side < 2; ++side) {
      const double across = side == 0 ? -0.3 : 0.3;
      const double radius = 1 + across * std::cos(tilt);
      band.vertices.row(2 * i + side) << radius * std::cos(angle), radius * std::sin(angle), across * std::sin(tilt);
    }
    const bool swaps = i + 1 == around && half_turns % 2 != 0;
    const int here = 2 * i;
    const int next = (here + 2) % rows;
    const int low = next + (swaps ? 1 : 0);
    const int high = next + (swaps ? 0 : 1);
    band.triangles.row(here) << here, here + 1, high;
    band.triangles.row(here + 1) << here, high, low;
  }
  return band;
}

Shape soup(const Shape& shape) {
  const Eigen::Index count = shape.triangles.rows();
  Shape result{Points(3 * count, 3), Triangles(count, 3)};
  for (Eigen::Index i = 0; i < 3 * count; ++i) {
    result.vertices.row(i) = shape.vertices.row(shape.triangles(i / 3, i % 3));
    result.triangles(i / 3, i % 3) = static_cast<std::int32_t>(i);
  }
  return result;
}

Shape flipped(const Shape& shape) {
  Shape result = shape;
  result.triangles.col(1).swap(result.triangles.col(2));
  return result;
}

Permuted permuted(const Shape& shape, unsigned seed) {
  Permuted result;
  std::mt19937 random(seed);
  result.vertices.resize(shape.vertices.rows());
  result.triangles.resize(shape.triangles.rows());
  std::iota(result.vertices.begin(), result.vertices.end(), 0);
  std::iota(result.triangles.begin(), result.triangles.end(), 0);
  std::shuffle(result.vertices.begin(), result.vertices.end(), random);
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  std::vector<std::int32_t> new_index(result.vertices.size());
  result.shape = shape;
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    new_index[result.vertices[i]] = static_cast<std::int32_t>(i);
    result.shape.vertices.row(static_cast<Eigen::Index>(i)) = shape.vertices.row(result.vertices[i]);
  }
  for (std::size_t f = 0; f < result.triangles.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      result.shape.triangles(static_cast<Eigen::Index>(f), k) =
          new_index[shape.triangles(result.triangles[f], (k + static_cast<int>(f)) % 3)];
    }
  }
  return result;
}

Eigen::Matrix3d rotation(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const double z = normal(random);
  const double y = normal(random);
  const double x = normal(random);
  const double w = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

double signed_volume(const Shape& mesh) {
  double volume = 0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(f, 0));
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(f, 1));
    const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(f, 2));
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

Shape random_points(const Shape& mesh, Eigen::Index count, std::uint64_t seed) {
  std::vector<double> areas_up_to;
  double total = 0;
  for (const double area : triangle_areas(mesh)) areas_up_to.push_back(total += area);
  RandomNumbers random(seed);
  Shape cloud;
  cloud.vertices.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto found = std::ranges::upper_bound(areas_up_to, random.uniform(0, total));
    const auto f = std::min<Eigen::Index>(found - areas_up_to.begin(), mesh.triangles.rows() - 1);
    double u = random.uniform(0, 1);
    double v = random.uniform(0, 1);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    cloud.vertices.row(i) = (1 - u - v) * mesh.vertices.row(mesh.triangles(f, 0)) +
                            u * mesh.vertices.row(mesh.triangles(f, 1)) + v * mesh.vertices.row(mesh.triangles(f, 2));
  }
  return cloud;
}

}  // namespace shapegauge::test
