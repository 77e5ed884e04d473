#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <set>

#include "shapegauge/experiments/generator/articulated_body.h"
#include "shapegauge/experiments/generator/classes/class_skeletons.h"
#include "shapegauge/experiments/generator/self_intersections.h"
#include "tests/experiments/generator/mesh_topology.h"

namespace shapegauge {
namespace {

constexpr int faces = 2000;

double least_height_to_length(const Shape& shape) {
  double least = 1;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(f, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(f, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(f, 2));
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    least = std::min(least, (b - a).cross(c - a).norm() / longest);
  }
  return least;
}

// Median over the edges of |length in a / length in b - 1|.
double edge_change(const Shape& a, const Shape& b) {
  std::vector<double> changes;
  for (Eigen::Index f = 0; f < a.triangles.rows(); ++f) {
    const int i = a.triangles(f, 0);
    const int j = a.triangles(f, 1);
    changes.push_back(
        std::abs((a.vertices.row(i) - a.vertices.row(j)).norm() / (b.vertices.row(i) - b.vertices.row(j)).norm() - 1));
  }
  std::nth_element(changes.begin(), changes.begin() + static_cast<std::ptrdiff_t>(changes.size() / 2), changes.end());
  return changes[changes.size() / 2];
}

// Largest change of a distance between two vertices, relative to the diagonal.
double largest_distance_change(const Shape& a, const Shape& b) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a.vertices.rows(); i += 7) {
    for (Eigen::Index j = 0; j < i; j += 7) {
      const double before = (a.vertices.row(i) - a.vertices.row(j)).norm();
      const double after = (b.vertices.row(i) - b.vertices.row(j)).norm();
      largest = std::max(largest, std::abs(before - after));
    }
  }
  return largest / bounding_box_diagonal(a);
}

class EveryClass : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryClass, IsASoundMeshWithAllItsPartsThatBends) {
  const ArticulatedBody body = make_body(class_skeleton(GetParam()), faces);
  EXPECT_NEAR(static_cast<double>(body.triangles.rows()), faces, 0.2 * faces);

  ASSERT_EQ(body.labels.size(), body.triangles.rows());
  const std::set<int> parts(body.labels.begin(), body.labels.end());
  EXPECT_EQ(parts.size(), body.skeleton.limbs.size());
  EXPECT_EQ(*parts.begin(), 0);
  EXPECT_EQ(*parts.rbegin(), static_cast<int>(body.skeleton.limbs.size()) - 1);

  const Shape rest{body.rest.points, body.triangles};
  EXPECT_EQ(topology_fault(rest), "");
  EXPECT_FALSE(self_intersects(rest));
  Shape previous = rest;
  double largest_bend = 0;
  for (std::uint64_t i = 0; i < 3; ++i) {
    RandomNumbers random(11, i);
    const Shape model = draw_model(body, random);
    EXPECT_EQ(topology_fault(model), "");
    EXPECT_FALSE(self_intersects(model));
    EXPECT_GT(least_height_to_length(model), 1e-3);
    EXPECT_TRUE(model.vertices.allFinite());
    // Individuals differ by 7 % at most each; a pose moves parts apart but hardly stretches the skin.
    EXPECT_LT(edge_change(model, previous), 0.15);
    EXPECT_NEAR(surface_area(model) / surface_area(rest), 1, 0.2);
    const double bend = largest_distance_change(model, previous);
    EXPECT_GT(bend, 0.01);
    largest_bend = std::max(largest_bend, bend);
    previous = model;
  }
  EXPECT_GT(largest_bend, 0.08);
}

INSTANTIATE_TEST_SUITE_P(Generator, EveryClass, testing::Range(std::size_t{0}, class_count()),
                         [](const auto& parameter) { return class_skeleton(parameter.param).name; });

TEST(DrawModel, PosesBendMoreThanIndividualsDiffer) {
  // The same individual (same first numbers) at rest and in its pose: distances change, edges hardly do.
  const ArticulatedBody body = make_body(class_skeleton(3), faces);  // octopus
  RandomNumbers random(1, 1);
  RandomNumbers same(1, 1);
  const Shape posed = draw_model(body, random);
  const Shape straight{draw_individual(body.skeleton, body.rest, body.weights, same).points, body.triangles};
  EXPECT_LT(edge_change(posed, straight), 0.05);
  EXPECT_GT(largest_distance_change(straight, posed), 0.2);
}

TEST(DrawModel, SaysSoWhereNoPoseIsSound) {
  ArticulatedBody body = make_body(class_skeleton(11), 1000);  // lamp
  body.rest.points.col(2).setZero();
  RandomNumbers random(1);
  EXPECT_THROW(draw_model(body, random), std::runtime_error);
}

}  // namespace
}  // namespace shapegauge
