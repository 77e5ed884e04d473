// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/formats.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

Points three_points() { return (Points(3, 3) << 0, 0, 0.5, 1, 0, -2, 0, 1e3, 0).finished(); }

Shape expect_three_points(const std::string& text) {
  Shape shape = read_xyz(text, "c.xyz");
  EXPECT_EQ(shape.vertices, three_points()) << text;
  EXPECT_TRUE(is_cloud(shape));
  return shape;
}

TEST(ReadXyz, ReadsThreeColumnsAsPointCoordinates) {
  EXPECT_EQ(expect_three_points("0 0 .5\n1 0 -2\n+0 1e3 0\n").normals.rows(), 0);
}

TEST(ReadXyz, AcceptsAnySeparatorsCommentsAndLineEnds) {
  for (const char* text :
       {"0,0,.5\n1,0,-2\n0,1000,0\n", "0, 0, .5\n1, 0, -2\n0, 1000, 0", "0;0;.5\n1;0;-2\n0;1e3;0\n",
        "0\t0  .5\r\n\r\n1 0 -2\r\n 0 1e3 0\r\n", "0 0 .5\r1 0 -2\r0 1e3 0\r",
        "\xEF\xBB\xBF# by hand\n//x y z\n0 0 .5 // one\n1 0 -2# two\n\n  \n0 1e3 0\n#\n",
        "3\n0 0 .5\n1 0 -2\n0 1e3 0\n", "2\n0 0 .5\n1 0 -2\n1\n0 1e3 0\n", "X Y Z\n0 0 .5\n1 0 -2\n0 1e3 0\n",
        "x,y,z\n0,0,.5\n1,0,-2\n0,1e3,0\n", " 3 # points\n0 0 .5\n1 0 -2\n0 1e3 0\n"}) {
    EXPECT_EQ(expect_three_points(text).normals.rows(), 0);
  }
}

TEST(ReadXyz, TreatsColumnsFourToSixAsNormalsIfOfUnitLength) {
  const Shape shape = expect_three_points("0 0 .5 0 0 1.02\n1 0 -2 0.6 0 -0.8\n0 1e3 0 0 0 0\n");
  EXPECT_TRUE(shape.normals.isApprox((Points(3, 3) << 0, 0, 1, 0.6, 0, -0.8, 0, 0, 0).finished(), 1e-15));
}

TEST(ReadXyz, IgnoresColumnsBeyondTheNormals) {
  const Shape shape = expect_three_points("0 0 .5 0 0 1 255 x 0\n1 0 -2 0 0 -1 0 y nan\n0 1e3 0 1 0 0 0 z 0\n");
  EXPECT_EQ(shape.normals, (Points(3, 3) << 0, 0, 1, 0, 0, -1, 1, 0, 0).finished());
}

TEST(ReadXyz, DoesNotTreatColoursAndOtherColumnsAsNormals) {
  for (const char* text :
       {"0 0 .5 255 0 0\n1 0 -2 0 0 255\n0 1e3 0 255 255 0\n",      // 8-bit colours
        "0 0 .5 .2 .2 .2\n1 0 -2 1 1 1\n0 1e3 0 .5 .5 .5\n",        // grey levels
        "3\n0 0 .5 -12 1 0 0\n1 0 -2 99 1 0 0\n0 1e3 0 7 0 0 1\n",  // intensity and colour
        "0 0 .5 0 0 0\n1 0 -2 0 0 0\n0 1e3 0 0 0 0\n",              // all zero
        "0 0 .5 1 0 0\n1 0 -2 0 1 0\n0 1e3 0 0 0 1\n",              // one-hot labels
        "0 0 .5 1 0 0\n1 0 -2 1 0 0\n0 1e3 0 1 0 0\n",              // pure red
        "x y z u v w\n0 0 .5 -1 0 0\n1 0 -2 1 0 0\n0 1e3 0 0 1 0\n", "0 0 .5 9\n1 0 -2 nan\n0 1e3 0 7\n",
        "0 0 .5 0 1\n1 0 -2 0 1\n0 1e3 0 1 0\n", "0 0 .5 a b c\n1 0 -2 d e f\n0 1e3 0 g h i\n"}) {
    EXPECT_EQ(expect_three_points(text).normals.rows(), 0) << text;
  }
}

TEST(ReadXyz, AcceptsNormalsIfOneInTenIsNotOfUnitLength) {
  std::string text = "9 9 9 0 3 4\n";
  for (int i = 0; i < 8; ++i) text += "0 0 0 0 0 -1\n";
  EXPECT_EQ(read_xyz(text, "c.xyz").normals.rows(), 0);
  const Shape shape = read_xyz(text + "0 0 0 0 0 1\n", "c.xyz");
  ASSERT_EQ(shape.normals.rows(), 10);
  EXPECT_TRUE(shape.normals.row(0).isApprox(Eigen::RowVector3d(0, 0.6, 0.8), 1e-15));
}

TEST(ReadXyz, ReadsPwnNormalsAfterThePoints) {
  const Shape shape = expect_three_points("3\n0 0 .5\n1 0 -2\n0 1e3 0\n0 0 1\n0 -5 0\n0 0 0\n");
  EXPECT_EQ(shape.normals, (Points(3, 3) << 0, 0, 1, 0, -1, 0, 0, 0, 0).finished());
}

TEST(ReadXyz, ReadsPwnNormalsOnTheLinesOfPoints) {
  const Shape shape = expect_three_points("3\n0 0 .5 0 0 1\n1 0 -2 0 -1 0\n0 1e3 0 0 0 0\n");
  EXPECT_EQ(shape.normals, (Points(3, 3) << 0, 0, 1, 0, -1, 0, 0, 0, 0).finished());
}

TEST(ReadXyz, NormalisesNormalsOfAnySize) {
  for (const char* size : {"1e-310", "1e-200", "1e200", "1e308"}) {
    const std::string text = std::string("1\n0 0 0\n") + size + " 0 -" + size + "\n";
    const Shape shape = read_xyz(text, "c.xyz");
    ASSERT_EQ(shape.normals.rows(), 1) << text;
    EXPECT_TRUE(shape.normals.isApprox(Points(Eigen::RowVector3d(1, 0, -1).normalized()), 1e-14)) << text;
  }
}

TEST(ReadXyz, RefusesMissingCoordinatesDecimalCommasAndWrongPointCounts) {
  test::expect_refused({{"0 0 0\n1 2\n0 0 0\n", "c.xyz:2: expected 3 coordinates of a point, found 2"},
                        {"0 0 0\n\n7\n", "c.xyz:3: expected 3 coordinates of a point, found 1"},
                        {"x,y\n0,0,0\n", "c.xyz:1: expected a coordinate"},
                        {",x,y,z\n7,0,0,0\n", "c.xyz:2: the first line names 3 columns, but the first point has 4"},
                        {"0,0,0,0\n1,,2,3\n", "c.xyz:2: expected 3 coordinates of a point, found an empty cell"},
                        {"0;0;0;;0\n ;1;2;3;4\n", "c.xyz:2: expected 3 coordinates of a point, found an empty cell"},
                        {"0 0 0\n0 zero 0\n", "c.xyz:2: expected a coordinate"},
                        {"0 0 0\n0 0 -inf\n", "c.xyz:2: a coordinate is not a finite number"},
                        {"0 0 0 1 2\n0 0 0 1\n", "c.xyz:2: expected 5 columns"},
                        {"0 0 0 0 0 -1\n0 0 0 0 0 nan\n0 0 0 0 0 nan\n", "c.xyz:2: the normal"},
                        {"0 0 0 0 0 -1\n0 0 0 inf 0 0\n0 0 0 0 0 nan\n", "c.xyz:2: the normal"},
                        {"0 0 0 0 0 -1\n0 0 0 0 x 0\n0 0 0 0 0 nan\n", "c.xyz:2: the normal"},
                        {"#\n0,5 1,5 -2,5\n", "c.xyz:2: commas"},
                        {"#\n0,5;1,5;-2,5\n", "c.xyz:2: commas"},
                        {"#\n0,5\t1\t2\n", "c.xyz:2: commas"},
                        {"3\n0 0 0\n1 0 0\n", "2 of 3 points"},
                        {"1\n0 0 0\n1 0 0\n0 0 0\n", "found 3 points, but the first line announces 1"},
                        {"1\n0 0 0 1\n1 0 0 1\n", "found 2 points, but the first line announces 1"},
                        {"-1\n0 0 0\n", "c.xyz:1: expected 0 to 2147483647 points, found -1"},
                        {"1\n0 0 0\n9223372036854775807\n0 0 1\n",
                         "c.xyz:3: expected 0 to 2147483647 points, found 9223372036854775807"},
                        {"1.5\n0 0 0\n", "c.xyz:1: expected the number of points"},
                        {"# nothing\n\n", "only white space"}},
                       [](const std::string& text) { read_xyz(text, "c.xyz"); });
}

TEST(ReadXyz, RefusesARunningIndexAsFirstColumn) {
  for (const int first : {0, 1, 2}) {
    std::string text;
    for (int i = 0; i < 12; ++i) text += fmt::format("{} 0.5 {} 1\n", first + i, i % 3);
    const auto read = [&] { return read_xyz(text, "c.xyz"); };
    if (first == 2) {
      EXPECT_EQ(read().vertices.rows(), 12);
    } else {
      EXPECT_THAT(test::input_error_of(read), testing::HasSubstr("counts the points"));
    }
  }
}

TEST(ReadXyz, HeaderCheckRejectsTextWithoutNumbers) {
  EXPECT_NO_THROW(check_xyz_header("# x\n 12\n0 0", "c.xyz"));
  EXPECT_NO_THROW(check_xyz_header("0 0 0\n0 0", "c.xyz"));
  EXPECT_THROW(check_xyz_header("hello\n", "c.xyz"), InputError);
  EXPECT_THROW(check_xyz_header("# hello\n", "c.xyz"), InputError);
}

}  // namespace

}  // namespace shapegauge
