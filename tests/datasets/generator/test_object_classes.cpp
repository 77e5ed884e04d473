// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <optional>
#include <set>

#include "shapegauge/datasets/generator/mesh_implicit_surface.h"
#include "shapegauge/datasets/generator/mesh_solid.h"
#include "shapegauge/datasets/generator/object_classes.h"
#include "tests/datasets/generator/mesh_topology.h"

namespace shapegauge {

namespace {

class EveryObjectClass : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryObjectClass, HasValidMeshesOfSeveralParts) {
  const ObjectClass& objects = object_classes()[GetParam()];
  RandomNumbers random(5);
  int made = 0;
  std::set<int> seen;
  std::set<double> areas;
  for (int attempt = 0; attempt < 6 && made < 2; ++attempt) {
    const std::optional<SolidMesh> object = mesh_solid(objects.draw(random), 1000);
    if (!object) continue;
    ++made;
    EXPECT_GT(object->mesh.triangles.rows(), 800);
    EXPECT_EQ(topology_fault(object->mesh), "");
    EXPECT_FALSE(self_intersects(object->mesh));
    ASSERT_EQ(object->labels.size(), object->mesh.triangles.rows());
    seen.insert(object->labels.begin(), object->labels.end());
    areas.insert(surface_area(object->mesh));
  }
  EXPECT_EQ(made, 2);
  EXPECT_EQ(areas.size(), 2U);
  EXPECT_GE(seen.size(), 2U);
  EXPECT_GE(*seen.begin(), 0);
  EXPECT_LT(*seen.rbegin(), static_cast<int>(objects.parts.size()));
}

INSTANTIATE_TEST_SUITE_P(Generator, EveryObjectClass, testing::Range(std::size_t{0}, object_classes().size()),
                         [](const auto& parameter) { return object_classes()[parameter.param].name; });

TEST(ObjectClasses, MugHasOnePartForBothSidesOfItsWall) {
  RandomNumbers random(7);
  const SolidObject mug = object_classes()[0].draw(random);
  std::optional<SolidMesh> made = mesh_solid(mug, 3000);
  ASSERT_TRUE(made);
  ASSERT_EQ(object_classes()[0].name, "mug");
  int inner = 0;
  int outer = 0;
  for (Eigen::Index f = 0; f < made->labels.size(); ++f) {
    const Eigen::Matrix3d corners = made->mesh.vertices(made->mesh.triangles.row(f), Eigen::all);
    const Eigen::RowVector3d middle = corners.colwise().mean();
    const Eigen::RowVector3d normal = (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
    if (made->labels[f] != 0) continue;
    const double outwards = normal.head<2>().dot(middle.head<2>());
    (outwards < 0 ? inner : outer) += 1;
  }
  EXPECT_GT(inner, 500);
  EXPECT_GT(outer, 500);
}

}  // namespace

}  // namespace shapegauge
