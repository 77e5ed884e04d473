#include <filesystem>
#include <gmock/gmock.h>
#include <limits>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/stl.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::as_ascii_stl;
using test::as_binary_stl;
using test::expect_same;
using ::testing::StrEq;
using ::testing::ThrowsMessage;

/// The tetrahedron with vertices in order of first use by its triangles.
Shape renumbered_tetrahedron() {
  Shape shape;
  shape.vertices.resize(4, 3);
  shape.vertices << 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1;
  shape.triangles.resize(4, 3);
  shape.triangles << 0, 1, 2, 0, 2, 3, 0, 3, 1, 2, 1, 3;
  return shape;
}

void expect_stl_error(const std::string& bytes, const std::string& message) {
  EXPECT_THAT([&] { read_stl(bytes, "t.stl"); }, ThrowsMessage<InputError>(StrEq(message))) << bytes;
}

std::string with_first_replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST(ReadStl, Ascii) { expect_same(read_stl(as_ascii_stl(test::tetrahedron()), "t.stl"), renumbered_tetrahedron()); }

TEST(ReadStl, Binary) { expect_same(read_stl(as_binary_stl(test::tetrahedron()), "t.stl"), renumbered_tetrahedron()); }

TEST(ReadStl, BinaryThatBeginsWithSolid) {
  const std::string bytes = as_binary_stl(test::tetrahedron(), "solid by an exporter\nfacet normal");
  expect_same(read_stl(bytes, "t.stl"), renumbered_tetrahedron());
  expect_same(read_stl(bytes + "data behind", "t.stl"), renumbered_tetrahedron());
}

TEST(ReadStl, AsciiOnOneLineInCapitalsAndOfTwoSolids) {
  const std::string facet =
      "FACET NORMAL nan nan nan OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET ";
  const Shape shape = read_stl("SOLID\n" + facet + facet + "ENDSOLID\nsolid b\n" + facet + "endsolid b", "t.stl");
  EXPECT_EQ(shape.vertices.rows(), 3);
  EXPECT_EQ(shape.triangles, (Triangles(3, 3) << 0, 1, 2, 0, 1, 2, 0, 1, 2).finished());
}

TEST(ReadStl, ZeroAndMinusZeroAreOneVertex) {
  Shape shape = renumbered_tetrahedron();
  shape.vertices.row(3).setConstant(-0.0);
  const Shape read = read_stl(as_binary_stl(shape), "t.stl");
  EXPECT_EQ(read.vertices.rows(), 3);
  EXPECT_EQ(read.triangles, (Triangles(4, 3) << 0, 1, 2, 0, 2, 0, 0, 0, 1, 2, 1, 0).finished());
}

TEST(ReadStl, BinaryTruncated) {
  for (const std::string header : {"binary", "solid"}) {
    const std::string bytes = as_binary_stl(test::tetrahedron(), header);
    expect_stl_error(bytes.substr(0, bytes.size() - 1),
                     "t.stl: ends after 3 of 4 facets; the file is truncated or its header is wrong");
  }
  expect_stl_error("binary", "t.stl: ends within its header of 84 bytes, or is not an STL file");
}

TEST(ReadStl, BinaryWithMoreFacetsThanAnnounced) {
  std::string bytes = as_binary_stl(test::tetrahedron());
  expect_stl_error(bytes + bytes,
                   "t.stl: its header announces 4 facets, but 9 follow: the number is wrong, or the file is several "
                   "files in one; repair it");
  bytes[80] = 0;
  expect_stl_error(bytes,
                   "t.stl: its header announces 0 facets, but 4 follow: the number is wrong, or the file is several "
                   "files in one; repair it");
}

TEST(ReadStl, AsciiTruncated) {
  const std::string text = as_ascii_stl(test::tetrahedron());
  expect_stl_error(text.substr(0, text.find("endsolid")), "t.stl: ends after 4 facets, before \"endsolid\"");
  expect_stl_error(text.substr(0, text.rfind("endloop")), "t.stl: ends within facet 3");
  expect_stl_error("solid x\n", "t.stl: ends after 0 facets, before \"endsolid\"");
}

TEST(ReadStl, AsciiWithSomethingElse) {
  const std::string text = as_ascii_stl(test::tetrahedron());
  expect_stl_error(with_first_replaced(text, "facet", "hello"),
                   "t.stl:2: expected \"facet\" or \"endsolid\", found \"hello\"");
  expect_stl_error(with_first_replaced(text, "outer", "inner"),
                   "t.stl:3: expected \"outer\" in facet 0, found \"inner\"");
  expect_stl_error(with_first_replaced(text, "vertex 0 0 0", "vertex 0 0 x"),
                   "t.stl:4: expected a coordinate, found \"x\"");
  expect_stl_error(with_first_replaced(text, "endloop", "vertex"),
                   "t.stl:7: expected \"endloop\" in facet 0, found \"vertex\"");
}

TEST(ReadStl, CoordinateThatIsNotFinite) {
  expect_stl_error(with_first_replaced(as_ascii_stl(test::tetrahedron()), "vertex 0 1 0", "vertex 0 inf 0"),
                   "t.stl:5: a coordinate is not a finite number: \"inf\"; repair or remove the file");
  Shape shape = test::tetrahedron();
  shape.vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
  expect_stl_error(as_binary_stl(shape),
                   "t.stl: facet 1 has a coordinate that is not a finite number; repair or remove the file");
}

TEST(ReadStl, HeaderAloneCanBeChecked) {
  EXPECT_NO_THROW(check_stl_header("solid x\n", "t.stl"));
  EXPECT_NO_THROW(check_stl_header(as_binary_stl(test::tetrahedron()).substr(0, 84), "t.stl"));
  EXPECT_THROW(check_stl_header("hello", "t.stl"), InputError);
}

TEST(WriteStl, IsTheBinaryFormatByteForByte) {
  const test::TemporaryFolder folder;
  Shape triangle;
  triangle.vertices.resize(3, 3);
  triangle.vertices << 0, 0, 0, 0, 2, 0, 0, 0, 3;  // its normal is along x
  triangle.triangles.resize(1, 3);
  triangle.triangles << 0, 1, 2;
  write_stl(folder.path() / "t.stl", triangle);
  const std::string bytes = test::bytes_of(folder.path() / "t.stl");
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

TEST(WriteStl, DegenerateTrianglesHaveNoNormal) {
  const test::TemporaryFolder folder;
  Shape flat = test::tetrahedron();
  flat.vertices.setOnes();
  write_stl(folder.path() / "t.stl", flat);
  const std::string bytes = test::bytes_of(folder.path() / "t.stl");
  EXPECT_EQ(bytes.substr(84, 12), std::string(12, '\0'));
  EXPECT_EQ(read_stl(bytes, "t.stl").triangles.rows(), 4);
}

TEST(WriteStl, LossOfPrecisionIsAWarning) {
  Shape shape = test::tetrahedron();
  EXPECT_EQ(precision_warning("x.stl", shape), std::nullopt);
  shape.vertices = (0.3 * shape.vertices).array() + 1e4;  // not in single precision
  const std::string moved = precision_warning("x.STL", shape).value_or("none");
  EXPECT_THAT(moved, testing::AllOf(testing::HasSubstr("% of the diagonal"), testing::HasSubstr("centre the shape"),
                                    testing::Not(testing::HasSubstr("equal"))));
  shape.vertices.array() += 1e9;
  EXPECT_THAT(precision_warning("x.stl", shape).value_or("none"), testing::HasSubstr("makes 3 vertices equal"));
  EXPECT_EQ(precision_warning("x.ply", shape), std::nullopt);
}

TEST(WriteStl, RefusesWhatTheFormatCannotHold) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(write_stl(folder.path() / "t.stl", test::small_cloud()), InputError);
  Shape large = test::tetrahedron();
  large.vertices(3, 2) = 1e39;
  EXPECT_THROW(write_stl(folder.path() / "t.stl", large), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "t.stl"));
}

}  // namespace

}  // namespace shapegauge
