// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/datasets/generator/mesh_implicit_surface.h"
#include "tests/datasets/generator/mesh_topology.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

Skeleton straight_rod() {
  return {"rod", {{.kind = "rod", .nodes = {{{-1, 0, 0}, 0.3}, {{0, 0, 0}, 0.3}, {{1, 0, 0}, 0.3}}}}};
}

/// Expects the number of triangles asked for, within 20 %, and no angle below 30 degrees.
void expect_regular(const Shape& mesh, int faces) {
  EXPECT_NEAR(static_cast<double>(mesh.triangles.rows()), faces, 0.2 * faces);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d corner = mesh.vertices.row(mesh.triangles(f, k));
      const Eigen::Vector3d u = mesh.vertices.row(mesh.triangles(f, (k + 1) % 3)).transpose() - corner;
      const Eigen::Vector3d v = mesh.vertices.row(mesh.triangles(f, (k + 2) % 3)).transpose() - corner;
      EXPECT_GE(std::acos(u.normalized().dot(v.normalized())), std::numbers::pi / 6 * (1 - 1e-9));
    }
  }
}

TEST(MeshImplicitSurface, CapsuleMeshHasTheAreaAndVolumeOfTheCapsule) {
  const ImplicitSurface surface(straight_rod());
  const Shape mesh = mesh_implicit_surface(surface, 8000);
  EXPECT_EQ(topology_fault(mesh), "");
  expect_regular(mesh, 8000);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    EXPECT_NEAR(surface(mesh.vertices.row(i).transpose()), 0, 1e-6);
  }
  constexpr double pi = std::numbers::pi;
  // Chords of length h err by (h / r)^2 / 24 or so; here h is about 0.03.
  EXPECT_NEAR(surface_area(mesh), 2 * pi * 0.3 * 2 + 4 * pi * 0.09, 0.01);
  EXPECT_NEAR(test::signed_volume(mesh), pi * 0.09 * 2 + 4 * pi * 0.027 / 3, 0.005);
}

TEST(MeshImplicitSurface, MeshOfFewTrianglesHasNoAngleBelow30Degrees) {
  expect_regular(mesh_implicit_surface(ImplicitSurface(straight_rod()), 1000), 1000);
}

TEST(MeshImplicitSurface, MeshOfAThinRingHasTheTopologyOfATorus) {
  Skeleton s{"ring", {}};
  Limb ring{.kind = "ring", .nodes = {}};
  for (int i = 0; i <= 12; ++i) {
    const double angle = 2 * std::numbers::pi * i / 12;
    ring.nodes.push_back({{std::cos(angle), std::sin(angle), 0}, 0.08});
  }
  add_limb(s, ring);
  const ImplicitSurface surface(s);
  const Shape mesh = mesh_implicit_surface(surface, 2000);
  EXPECT_EQ(topology_fault(mesh), "");
  // Euler characteristic of a torus; a closed triangle mesh has 3/2 edges a triangle.
  EXPECT_EQ(2 * mesh.vertices.rows(), mesh.triangles.rows());
}

TEST(SelfIntersections, AreFoundWhereTwoSpheresCross) {
  const Shape sphere = test::sphere(1, 2);
  const auto moved = [&](double x) {
    return test::transformed(sphere, 1, Eigen::Matrix3d::Identity(), {x, 0.01, 0.02});
  };
  EXPECT_FALSE(self_intersects(sphere));
  EXPECT_TRUE(self_intersects(test::joined({sphere, moved(1.9)})));
  EXPECT_FALSE(self_intersects(test::joined({sphere, moved(2.1)})));
}

}  // namespace

}  // namespace shapegauge
