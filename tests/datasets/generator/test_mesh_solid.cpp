// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>
#include <set>

#include "shapegauge/datasets/generator/mesh_implicit_surface.h"
#include "shapegauge/datasets/generator/mesh_solid.h"
#include "tests/datasets/generator/mesh_topology.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

TEST(MeshSolid, MeshOfACylinderOfTwoPartsIsClosedAndLabelled) {
  const Solid cylinder = rounded_cylinder({0, 0, -0.5}, {0, 0, 0.5}, 0.5, 0.05);
  SolidObject object;
  object.parts = {{0, intersection(cylinder, slab(-1, 0.05))}, {4, intersection(cylinder, slab(0, 1))}};
  object.thinnest = 0.5;
  object.blend = 0.01;
  const std::optional<SolidMesh> made = mesh_solid(object, 2000);
  ASSERT_TRUE(made);
  EXPECT_NEAR(static_cast<double>(made->mesh.triangles.rows()), 2000, 400);
  EXPECT_EQ(topology_fault(made->mesh), "");
  EXPECT_FALSE(self_intersects(made->mesh));
  // Chords and rounding reduce it by a few percent.
  EXPECT_NEAR(test::signed_volume(made->mesh) / (std::numbers::pi * 0.25), 0.975, 0.02);
  for (Eigen::Index f = 0; f < made->labels.size(); ++f) {
    const Eigen::Matrix3d corners = made->mesh.vertices(made->mesh.triangles.row(f), Eigen::all);
    const double height = corners.col(2).mean();
    // Chords lie below the surface, where the border is a little lower.
    if (std::abs(height - 0.05) > 0.01) {
      EXPECT_EQ(made->labels[f], height < 0.05 ? 0 : 4) << height;
    }
  }
}

TEST(MeshSolid, RejectsDisconnectedSolids) {
  SolidObject object;
  object.parts = {{0, rounded_box({-0.6, 0, 0}, {0.4, 0.4, 0.4}, 0.1)},
                  {1, rounded_box({0.6, 0, 0}, {0.4, 0.4, 0.4}, 0.1)}};
  object.thinnest = 0.5;
  EXPECT_FALSE(mesh_solid(object, 2000));
}

/// An object of one part.
SolidObject of_one_part(const Solid& solid, double thinnest) {
  SolidObject object;
  object.parts = {{2, solid}};
  object.thinnest = thinnest;
  return object;
}

TEST(MeshSolid, BallMeshHasTheAreaAndVolumeOfTheBall) {
  const double radius = 0.8;
  const Eigen::Vector3d centre(0.3, -0.2, 0.1);
  const Solid ball = rounded_box(centre, Eigen::Vector3d::Constant(radius), radius);
  for (const int faces : {500, 2000, 6000}) {
    const std::optional<SolidMesh> made = mesh_solid(of_one_part(ball, 2 * radius), faces);
    ASSERT_TRUE(made) << faces;
    EXPECT_EQ(topology_fault(made->mesh), "") << faces;
    EXPECT_NEAR(static_cast<double>(made->mesh.triangles.rows()), faces, 0.2 * faces);
    EXPECT_EQ(2 * made->mesh.vertices.rows(), made->mesh.triangles.rows() + 4) << "Euler characteristic of 2";
    // All relative to the radius. The step h of the grid has h^2 = 2 areas a face; along an edge of the grid, at most
    // sqrt(3) h long, the distance deviates from linear by up to 3 h^2 / 8, and a vertex is moved by up to 3 % of it.
    const double step = std::sqrt(8 * std::numbers::pi / faces);
    const double off = 3 * step * step / 8 + 0.03 * std::sqrt(3) * step;
    // An inscribed equilateral triangle with sides s lies up to s^2 / 6 below the sphere.
    const double below = 4 * std::numbers::pi / faces * 4 / std::numbers::sqrt3 / 6;
    for (const auto& vertex : made->mesh.vertices.rowwise()) {
      EXPECT_NEAR((vertex.transpose() - centre).norm() / radius, 1, off) << faces;
    }
    EXPECT_NEAR(surface_area(made->mesh) / (4 * std::numbers::pi * radius * radius), 1, 2 * (off + below)) << faces;
    EXPECT_NEAR(test::signed_volume(made->mesh) / (4.0 / 3 * std::numbers::pi * std::pow(radius, 3)), 1,
                3 * (off + below))
        << faces;
    EXPECT_TRUE((made->labels.array() == 2).all());
  }
}

TEST(MeshSolid, KeepsHolesAndThinWalls) {
  // A pipe: a cylinder without a thinner one, of genus 1.
  const double outer = 0.6;
  const double inner = 0.45;
  const double length = 1.2;
  const Solid pipe = difference(rounded_cylinder({0, 0, -length / 2}, {0, 0, length / 2}, outer, 0.01),
                                rounded_cylinder({0, 0, -length}, {0, 0, length}, inner, 0.01));
  const std::optional<SolidMesh> made = mesh_solid(of_one_part(pipe, outer - inner), 3000);
  ASSERT_TRUE(made);
  EXPECT_EQ(topology_fault(made->mesh), "");
  EXPECT_EQ(2 * made->mesh.vertices.rows(), made->mesh.triangles.rows()) << "Euler characteristic of 0";
  EXPECT_NEAR(test::signed_volume(made->mesh), std::numbers::pi * (outer * outer - inner * inner) * length, 0.03);
  for (const auto& vertex : made->mesh.vertices.rowwise()) {
    const double radius = vertex.head<2>().norm();
    EXPECT_GT(radius, inner - 0.02);
    EXPECT_LT(radius, outer + 0.01);
  }
}

TEST(MeshSolid, LabelsMatchTheObjectAtTheCentroids) {
  SolidObject object;
  object.parts = {{5, rounded_box({0, 0, 0}, {0.6, 0.6, 0.2}, 0.05)},
                  {1, rounded_box({0, 0, 0.5}, {0.2, 0.2, 0.5}, 0.05)}};
  object.thinnest = 0.4;
  const std::optional<SolidMesh> made = mesh_solid(object, 1500);
  ASSERT_TRUE(made);
  ASSERT_EQ(made->labels.size(), made->mesh.triangles.rows());
  for (Eigen::Index f = 0; f < made->labels.size(); ++f) {
    const Eigen::Matrix3d corners = made->mesh.vertices(made->mesh.triangles.row(f), Eigen::all);
    EXPECT_EQ(made->labels[f], object.label_at(corners.colwise().mean().transpose()));
  }
  EXPECT_EQ(std::set(made->labels.begin(), made->labels.end()), (std::set{1, 5}));
}

}  // namespace

}  // namespace shapegauge
