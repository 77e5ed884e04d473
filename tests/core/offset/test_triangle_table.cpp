// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/triangle_table.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {
namespace {

Eigen::Vector3d random_point(RandomNumbers& random, double size) {
  Eigen::Vector3d x;
  for (double& coordinate : x) coordinate = random.uniform(0, size);
  return x;
}

/// Random triangles, a third of them slivers, edges or points.
std::vector<Triangle> triangles_of_all_kinds(int count) {
  RandomNumbers random(1, 0);
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d a = random_point(random, 8);
    const Eigen::Vector3d b = a + random_point(random, 4);
    const Eigen::Vector3d c = a + random_point(random, 4);
    const double along = random.uniform(0, 1);
    switch (i % 9) {
      case 0:
        triangles.push_back({a, b, a + along * (b - a) + 1e-3 * c});
        break;
      case 1:
        triangles.push_back({a, b, a + along * (b - a)});
        break;
      case 2:
        triangles.push_back({a, a, a});
        break;
      default:
        triangles.push_back({a, b, c});
    }
  }
  return triangles;
}

TEST(TriangleTable, DistancesMatchTheClosestPointInDoublePrecision) {
  const std::vector<Triangle> triangles = triangles_of_all_kinds(800);
  TriangleTable table;
  table.resize(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    table.set(i, t.a.cast<float>(), t.b.cast<float>(), t.c.cast<float>());
  }
  ASSERT_EQ(table.size(), triangles.size());
  RandomNumbers random(2, 0);
  std::array<std::int32_t, TriangleTable::batch_size> numbers;
  for (std::size_t i = 0; i < triangles.size(); i += numbers.size()) {
    // In a different order, with one repetition.
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<std::int32_t>(i + (k == 7 ? 0 : 6 - k));
    const Eigen::Vector3d x = random_point(random, 10);
    TriangleTable::Vectors vectors;
    table.vectors_to(x, numbers.data(), vectors);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const Triangle& t = triangles[static_cast<std::size_t>(numbers[k])];
      const double distance = (x - closest_point(t, x)).norm();
      // The tolerance of single precision at coordinates of 10; the interior of slivers is represented by their edges.
      EXPECT_NEAR(vectors.vector(k).norm(), distance, 1e-4) << i << " " << k;
      EXPECT_NEAR(std::sqrt(static_cast<double>(vectors.squared[k])), distance, 1e-4) << i << " " << k;
      EXPECT_LT((x - vectors.vector(k) - closest_point(t, x - vectors.vector(k))).norm(), 1e-4) << "not on it";
    }
  }
}

TEST(TriangleTable, ComputesTheVectorsToTheClosestPointsOfTriangles) {
  const std::vector<Triangle> triangles = triangles_of_all_kinds(8);
  TriangleTable table;
  table.resize(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    table.set(i, t.a.cast<float>(), t.b.cast<float>(), t.c.cast<float>());
  }
  RandomNumbers random(3, 0);
  TriangleTable::Vectors vectors;
  std::array<Eigen::Vector3d, 8> points;
  std::array<std::int32_t, 8> numbers;
  for (std::size_t i = 0; i < 8; ++i) {
    points[i] = random_point(random, 10);
    numbers[i] = static_cast<std::int32_t>(i);
    vectors.set(i, points[i]);
  }
  table.vectors_to_each(vectors, numbers.data());
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(vectors.vector(i).norm(), (points[i] - closest_point(triangles[i], points[i])).norm(), 1e-4) << i;
  }
}

}  // namespace
}  // namespace shapegauge
