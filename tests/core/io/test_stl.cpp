// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>
#include <limits>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::as_ascii_stl;
using test::as_binary_stl;
using test::expect_same;

/// The tetrahedron with vertices in order of first use by its triangles.
Shape renumbered_tetrahedron() {
  return {.vertices = Points{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
          .triangles = Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}}};
}

std::string with_first_replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST(ReadStl, ReadsAsciiFiles) {
  const std::string text = as_ascii_stl(test::tetrahedron());
  for (const std::string& bytes : {text, "\xEF\xBB\xBF" + text}) {
    expect_same(read_stl(bytes, "t.stl"), renumbered_tetrahedron());
  }
}

TEST(ReadStl, ReadsBinaryFiles) {
  expect_same(read_stl(as_binary_stl(test::tetrahedron()), "t.stl"), renumbered_tetrahedron());
}

TEST(ReadStl, ReadsBinaryFilesThatBeginWithSolid) {
  const std::string bytes = as_binary_stl(test::tetrahedron(), "solid by an exporter\nfacet normal");
  expect_same(read_stl(bytes, "t.stl"), renumbered_tetrahedron());
  expect_same(read_stl(bytes + "data behind", "t.stl"), renumbered_tetrahedron());
}

TEST(ReadStl, ReadsAsciiOnOneLineInCapitalsAndOfTwoSolids) {
  const std::string facet =
      "FACET NORMAL nan nan nan OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET ";
  const Shape shape = read_stl("SOLID\n" + facet + facet + "ENDSOLID\nsolid b\n" + facet + "endsolid b", "t.stl");
  EXPECT_EQ(shape.vertices.rows(), 3);
  EXPECT_EQ(shape.triangles, (Triangles(3, 3) << 0, 1, 2, 0, 1, 2, 0, 1, 2).finished());
  EXPECT_TRUE(is_recognised_shape({.bytes = "Solid a\n" + facet + "ENDSOLID\n", .name = "standard input"}));
}

TEST(ReadStl, WeldsVerticesAtZeroAndMinusZero) {
  Shape shape = renumbered_tetrahedron();
  shape.vertices.row(3).setConstant(-0.0);
  const Shape read = read_stl(as_binary_stl(shape), "t.stl");
  EXPECT_EQ(read.vertices.rows(), 3);
  EXPECT_EQ(read.triangles, (Triangles(4, 3) << 0, 1, 2, 0, 2, 0, 0, 0, 1, 2, 1, 0).finished());
}

TEST(ReadStl, RefusesTruncatedFilesWrongCountsAndNonFiniteCoordinates) {
  const std::string text = as_ascii_stl(test::tetrahedron());
  const std::string bytes = as_binary_stl(test::tetrahedron());
  const std::string solid = as_binary_stl(test::tetrahedron(), "solid");
  std::string none_announced = bytes;
  none_announced[80] = 0;
  Shape not_finite = test::tetrahedron();
  not_finite.vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
  test::expect_refused({{bytes.substr(0, bytes.size() - 1), "3 of 4 facets"},
                        {solid.substr(0, solid.size() - 1), "3 of 4 facets"},
                        {"binary", "84 bytes"},
                        {bytes + bytes, "announces 4 facets, but 9 follow"},
                        {none_announced, "announces 0 facets, but 4 follow"},
                        {as_binary_stl(not_finite), "facet 1 has a coordinate"},
                        {text.substr(0, text.find("endsolid")), "ends after 4 facets"},
                        {text.substr(0, text.rfind("endloop")), "ends within facet 3"},
                        {"solid x\n", "ends after 0 facets"},
                        {with_first_replaced(text, "facet", "hello"), "t.stl:2: expected \"facet\" or \"endsolid\""},
                        {with_first_replaced(text, "outer", "inner"), "t.stl:3: expected \"outer\" in facet 0"},
                        {with_first_replaced(text, "vertex 0 0 0", "vertex 0 0 x"), "t.stl:4: expected a coordinate"},
                        {with_first_replaced(text, "endloop", "vertex"), "t.stl:7: expected \"endloop\" in facet 0"},
                        {with_first_replaced(text, "vertex 0 1 0", "vertex 0 inf 0"), "t.stl:5: a coordinate"}},
                       [](const std::string& file) { read_stl(file, "t.stl"); });
}

TEST(ReadStl, HeaderCheckRecognisesOnlyStlFiles) {
  EXPECT_NO_THROW(stl_format().check_header("solid x\n", "t.stl"));
  EXPECT_NO_THROW(stl_format().check_header(as_binary_stl(test::tetrahedron()).substr(0, 84), "t.stl"));
  EXPECT_THROW(stl_format().check_header("hello", "t.stl"), InputError);
}

using WriteStl = test::FolderTest;

TEST_F(WriteStl, WritesTheBinaryFormatByteForByte) {
  // its normal is along x
  const Shape triangle{.vertices = Points{{0, 0, 0}, {0, 2, 0}, {0, 0, 3}}, .triangles = Triangles{{0, 1, 2}}};
  write_stl(at("t.stl"), triangle);
  const std::string bytes = test::bytes_of(at("t.stl"));
  ASSERT_EQ(bytes.size(), 84U + 50U);
  using namespace std::string_literals;
  EXPECT_EQ(bytes.substr(80, 4), "\1\0\0\0"s);
  const std::string zero = "\0\0\0\0"s;
  const std::string one = "\0\0\x80\x3F"s;
  const std::string two = "\0\0\0\x40"s;
  const std::string three = "\0\0\x40\x40"s;
  EXPECT_EQ(bytes.substr(84),
            one + zero + zero + zero + zero + zero + zero + two + zero + zero + zero + three + "\0\0"s);
}

TEST_F(WriteStl, WritesZeroNormalsForDegenerateTriangles) {
  Shape flat = test::tetrahedron();
  flat.vertices.setOnes();
  write_stl(at("t.stl"), flat);
  const std::string bytes = test::bytes_of(at("t.stl"));
  EXPECT_EQ(bytes.substr(84, 12), std::string(12, '\0'));
  EXPECT_EQ(read_stl(bytes, "t.stl").triangles.rows(), 4);
}

TEST_F(WriteStl, WarnsOfCoordinatesThatLosePrecision) {
  Shape shape = test::tetrahedron();
  EXPECT_EQ(precision_warning("x.stl", shape), std::nullopt);
  shape.vertices = (0.3 * shape.vertices).array() + 1e4;  // not in single precision
  const std::string moved = precision_warning("x.STL", shape).value_or("none");
  EXPECT_THAT(moved,
              testing::AllOf(testing::HasSubstr("% of the diagonal"), testing::Not(testing::HasSubstr("equal"))));
  shape.vertices.array() += 1e9;
  EXPECT_THAT(precision_warning("x.stl", shape).value_or("none"), testing::HasSubstr("makes 3 vertices equal"));
  EXPECT_EQ(precision_warning("x.ply", shape), std::nullopt);
}

TEST_F(WriteStl, RejectsPointCloudsAndCoordinatesBeyondSinglePrecision) {
  EXPECT_THROW(write_stl(at("t.stl"), test::small_cloud()), InputError);
  Shape large = test::tetrahedron();
  large.vertices(3, 2) = 1e39;
  EXPECT_THROW(write_stl(at("t.stl"), large), InputError);
  EXPECT_FALSE(std::filesystem::exists(at("t.stl")));
}

}  // namespace

}  // namespace shapegauge
