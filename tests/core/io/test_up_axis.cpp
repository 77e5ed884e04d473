// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/io/up_axis.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

const Eigen::Vector3d x_axis(1, 0, 0);
const Eigen::Vector3d y_axis(0, 1, 0);
const Eigen::Vector3d z_axis(0, 0, 1);

TEST(UpDirection, IsReadFromAnAxisName) {
  const std::vector<Eigen::Vector3d> directions{x_axis, y_axis, z_axis, -x_axis, -y_axis, -z_axis};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const std::string_view word = words_of<UpAxis>[i + 1];
    EXPECT_EQ(up_direction(value_of_word<UpAxis>(word).value(), "a.off"), directions[i]) << word;
  }
}

TEST(UpDirection, DependsOnTheFileFormatByDefault) {
  for (const char* name : {"a.off", "a.OBJ", "a.gltf", "a.glb"}) {
    EXPECT_EQ(up_direction(UpAxis::automatic, name), y_axis) << name;
  }
  for (const char* name : {"a.stl", "a.ply", "a.xyz", "a", "-", ""}) {
    EXPECT_EQ(up_direction(UpAxis::automatic, name), z_axis) << name;
  }
}

TEST(UpDirection, IsReadFromACommentOfTheFile) {
  const test::TemporaryFolder folder;
  const auto up_of = [&](const std::string& text) {
    return up_direction(UpAxis::automatic, folder.file("a.off", text));
  };
  EXPECT_EQ(up_of("OFF\n0 0 0\n" + std::string(1000, '\n') + "# up: z\n"), z_axis);
  EXPECT_EQ(up_of("OFF\r\n# up: -x\r\n3 1 0\r\n"), -x_axis);
  EXPECT_EQ(up_of("OFF\n# up: z"), z_axis);
  for (const char* other : {"OFF\n3 1 0\n", "OFF\n# up: north\n3 1 0\n", "OFF\n# up: auto\n", "OFF\n# make up: z\n"}) {
    EXPECT_EQ(up_of(other), y_axis) << other;
  }
  EXPECT_EQ(up_direction(UpAxis::x, folder.file("b.off", "OFF\n# up: z\n3 1 0\n")), x_axis) << "the setting prevails";
}

}  // namespace

}  // namespace shapegauge
