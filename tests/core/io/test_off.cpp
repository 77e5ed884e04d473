// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/formats.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::expect_same;
using test::tetrahedron;

const std::string off_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string off_faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

void expect_off_tetrahedron(const std::string& text) { expect_same(read_off(text, "t.off"), tetrahedron()); }

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

TEST(ReadOff, AcceptsEveryFormOfTheHeader) {
  const std::string body = off_vertices + off_faces;
  const std::string plain = "OFF\n4 4 6\n" + body;
  for (const std::string& text :
       {plain, "4 4 6\n" + body, "off\n4 4 6\n" + body, "OFF 4 4 6\n" + body, "OFF4 4 6\n" + body, "COFF4 4 6\n" + body,
        "OFF\n4\n4\n6\n" + body, "\xEF\xBB\xBF" + plain,
        // the number of edges is ignored
        "OFF\n4 4 -17\n" + body, "OFF\n4 4\n" + body, "OFF\n4 4 ?\n" + body,
        // line ends and spaces
        replaced(plain, "\n", "\r\n"), replaced("OFF\n# comment\n4 4 6\n" + body, "\n", "\r"),
        plain.substr(0, plain.size() - 1), replaced(plain, " ", " \t  "), replaced(plain, "\n", " "),
        replaced(plain, " ", "\n"),
        replaced("COFF\n4 4 6\n" + replaced(off_vertices, "\n", " 1 0 0 1\n") + off_faces, "\n", " "),
        // other data after the last face, and faces without a triangle
        plain + "SKEL {}\n", plain + std::string(9, '\0'),
        "OFF\n4 7 6\n" + off_vertices + "0\n2 0 1\n1 3\n" + off_faces,
        // normals of a mesh
        "NOFF\n4 4 6\n" + replaced(off_vertices, "\n", " nan x\n") + off_faces}) {
    SCOPED_TRACE(text);
    expect_off_tetrahedron(text);
  }
}

TEST(ReadOff, SkipsCommentsAndBlankLinesAnywhere) {
  expect_off_tetrahedron(
      "# before\n\nOFF# behind the keyword\n#\n4 4 6 # behind the counts\n\n  # indented\n0 0 0#glued\n1 0 0 # v 1\n\n"
      "0 1 0\n#between\n0 0 1\n\n# faces\n3 0 2 1 # f 0\n3 0 1 3\n\t\n3 0 3 2\n3 1 2 3 # the last line has no end");
  expect_off_tetrahedron("OFF\n4 4 6\n0 # x\n0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 # then\n2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST(ReadOff, AcceptsNumbersWithExponents) {
  const Shape shape = read_off("OFF\n2 0 0\n1e2 -1.5E-3 +2.5e+1\n.5 5. 1e-400\n", "t.off");
  EXPECT_EQ(shape.vertices, (Points(2, 3) << 100, -0.0015, 25, 0.5, 5, 0).finished());
}

TEST(ReadOff, IgnoresColoursNormalsAndTextureAfterVertices) {
  const std::vector<std::string> extras = {" 255 0 0 255", " 0.1 0.2 0.3", " 0 0 1", " 0.5 0.5",
                                           " 0 0 1 255 0 0 255 0.5 0.5"};
  for (const std::string keyword : {"COFF", "NOFF", "STOFF", "CNOFF", "NCOFF", "STCOFF", "STNOFF", "STCNOFF", "OFF"}) {
    for (const std::string& extra : extras) {
      expect_off_tetrahedron(keyword + "\n4 4 6\n" + replaced(off_vertices, "\n", extra + "\n") + off_faces);
    }
  }
}

TEST(ReadOff, IgnoresColoursAfterFaces) {
  for (const std::string colour : {" 7", " 255 0 0", " 0.1 0.2 0.3 1", " 3 255 0 0", " # red"}) {
    expect_off_tetrahedron("OFF\n4 4 6\n" + off_vertices + replaced(off_faces, "\n", colour + "\n"));
  }
}

TEST(ReadOff, SplitsPolygonsIntoFans) {
  const Shape shape =
      read_off("OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 2 0\n5 0 1 2 4 3 255 0 0\n4 3 2 1 0\n", "t.off");
  EXPECT_EQ(shape.triangles, (Triangles(5, 3) << 0, 1, 2, 0, 2, 4, 0, 4, 3, 3, 2, 1, 3, 1, 0).finished());
}

TEST(ReadOff, KeepsNonManifoldDegenerateAndDuplicateFacesAndUnusedVertices) {
  const Shape shape = read_off(
      "OFF\n6 7 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n9 9 9\n"
      "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 0 1\n3 2 2 2\n3 0 1 2\n3 2 1 0\n",
      "t.off");
  EXPECT_EQ(shape.vertices.rows(), 6);
  EXPECT_EQ(shape.triangles,
            (Triangles(7, 3) << 0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 0, 1, 2, 2, 2, 0, 1, 2, 2, 1, 0).finished());
}

TEST(ReadOff, FileWithoutFacesIsAPointCloud) {
  const Shape shape = read_off("OFF\n4 0 0\n" + off_vertices, "t.off");
  EXPECT_EQ(shape.vertices, tetrahedron().vertices);
  EXPECT_EQ(shape.triangles.rows(), 0);
}

TEST(ReadOff, ReadsCloudNormalsOfNoffFiles) {
  const std::string lines = "0 0 0 0 0 2 9 9 9 9\n1 0 0 0 0 0 9 9 9 9\n";
  const Points expected = (Points(2, 3) << 0, 0, 1, 0, 0, 0).finished();
  for (const std::string& text :
       {"NOFF\n2 0 0\n" + lines, "NCOFF\n2 0 0\n" + lines, replaced("CNOFF\n2 0 0\n" + lines, "\n", " ")}) {
    EXPECT_EQ(read_off(text, "t.off").normals, expected) << text;
  }
  EXPECT_EQ(read_off("OFF\n2 0 0\n" + lines, "t.off").normals.rows(), 0);
  EXPECT_EQ(read_off("NOFF\n4 0 0\n" + off_vertices, "t.off").normals.rows(), 0);
}

TEST(ReadOff, ReadsBinaryFiles) { expect_same(read_off(test::as_binary_off(tetrahedron()), "t.off"), tetrahedron()); }

TEST(ReadOff, IgnoresColoursNormalsAndTextureOfBinaryFiles) {
  expect_same(read_off(test::as_binary_off(tetrahedron(), "COFF BINARY # a comment\r\n", 4), "t.off"), tetrahedron());
  expect_same(read_off(test::as_binary_off(tetrahedron(), "STCNOFF  BINARY\n", 9), "t.off"), tetrahedron());
}

TEST(ReadOff, RefusesTextThatIsNotAMesh) {
  const std::string counts = "OFF\n4 4 6\n";
  const std::string start = counts + off_vertices;
  test::expect_refused(
      {{"4OFF\n4\n4 4 6\n" + off_vertices + off_faces, "three dimensions"},
       {"nOFF\n4\n4 4 6\n" + off_vertices + off_faces, "three dimensions"},
       {"C4nOFF\n4\n4 4 6\n" + off_vertices + off_faces, "three dimensions"},
       {start + off_faces + start + off_faces, "t.off:11: another OFF file"},
       {"\nply\nformat ascii 1.0\n", "t.off:2: not an OFF file"},
       {"\nOFFX 1 2 3\n", "t.off:2: not an OFF file"},
       {"\n-4 4 6\n", "t.off:2: not an OFF file"},
       {"# nothing\n\n", "only white space"},
       {"OFF\n", "t.off: ends before"},
       {"OFF\n4", "t.off: ends before"},
       {"OFF\n4 -1 6\n", "t.off:2: 4 vertices and -1 faces"},
       {"OFF\n3000000000 1 0\n", "at most 2147483647"},
       {"OFF\nfour 4 6\n", "t.off:2: expected the number of vertices"},
       {"OFF\n4 2 6\n" + off_vertices + "2 0 1\n1 3\n", "none of its 2 faces"},
       {counts + "0 0 0\n1 0 0\n0 1", "2 of 4 vertices"},
       {counts + "0 0\n1 0\n0 1\n1 1\n" + off_faces, "2 of 4 faces"},
       {start + "3 0 2 1 255 0 0\n3 0 1 3 0 0 0\n", "2 of 4 faces"},
       {start + "3 0 2 1 255 0 0\n3 0 1 3 0 0 0\n3", "2 of 4 faces"},
       {start + "3 0 2 1 255 0 0\n3 0 1 3 0 0 0\n3 0 3\n", "2 of 4 faces"},
       {start + replaced(off_faces, "0 1 3", "0 1 4"), "t.off:8: face 1 refers to vertex 4"},
       {replaced(start + replaced(off_faces, "0 1 3", "0 -1 3"), "\n", "\r\n"), "t.off:8: face 1 refers to vertex -1"},
       {start + "-3 0 1 2\n", "t.off:7: face 0 cannot have -3 vertices"},
       {start + "3.5 0 1 2\n", "t.off:7: expected a face's number of vertices"},
       {"OFF\n4 1 6\n" + off_vertices + "2000000000 0 1 2\n", "t.off:7: face 0 has more than 100000 vertices"},
       {"OFF\n4 1 6\n" + off_vertices + "90000 0 1 2\n", "0 of 1 faces"},
       {counts + "0 0 0\n1 0 nan\n", "t.off:4: a coordinate is not a finite number"},
       {counts + "0 0 0\n1 0 0,5\n", "t.off:4: expected a coordinate"},
       {"OFF\n1 0 0\n0 0 \x01" + std::string(1000, '\x7F') + "\n", "found \"" + std::string(270, '?') + "..."},
       {"NOFF\n2 0 0\n0 0 0 0 0 1\n1 0 0 0 nan 0\n", "t.off:4: a normal's component"},
       {"NOFF\n2 0 0\n0 0 0 0 0 1\n1 0 0\n", "t.off:4: the normal of vertex 1"},
       {"NOFF\n2 0 0\n0 0 0 0 0 1\n1 0 0 0 1\n", "t.off:4: the normal of vertex 1"}},
      [](const std::string& text) { read_off(text, "t.off"); });
}

TEST(ReadOff, RefusesDamagedBinaryFiles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::string bytes = test::as_binary_off(tetrahedron());
  Shape wrong_index = tetrahedron();
  wrong_index.triangles(2, 1) = 4;
  Shape not_finite = tetrahedron();
  not_finite.vertices(3, 0) = infinity;
  Shape cloud = test::small_cloud();
  cloud.normals(1, 1) = infinity;
  const auto files = test::cloud_in_every_format(cloud);
  test::expect_refused(
      {{test::as_binary_off(wrong_index), "face 2 refers to vertex 4"},
       {test::as_binary_off(not_finite), "vertex 3 has a coordinate"},
       {std::ranges::find(files, "binary.off", &test::Encoded::file_name)->bytes, "vertex 1 has a normal"},
       {bytes.substr(0, 20), "ends before the numbers"},
       {bytes.substr(0, 70), "3 of 4 vertices"},
       {bytes.substr(0, bytes.size() - 1), "3 of 4 faces"}},
      [](const std::string& text) { read_off(text, "t.off"); });
}

TEST(ReadOff, HeaderCheckRecognisesOnlyOffFiles) {
  EXPECT_NO_THROW(off_format().check_header("OFF\n4 4 6\n", "t.off"));
  EXPECT_NO_THROW(off_format().check_header("OFF BINARY\n", "t.off"));
  EXPECT_THROW(off_format().check_header("OFF\n", "t.off"), InputError);
  EXPECT_THROW(off_format().check_header("HELLO\n4 4 6\n", "t.off"), InputError);
}

TEST(WriteOff, WritesCountsVerticesAndFacesAsText) {
  const test::TemporaryFolder folder;
  Shape shape = tetrahedron();
  shape.vertices(1, 0) = 0.1;
  shape.vertices(3, 2) = -1e-300;
  write_off(folder.path() / "t.off", shape);
  EXPECT_EQ(test::bytes_of(folder.path() / "t.off"),
            "OFF\n4 4 0\n0 0 0\n0.1 0 0\n0 1 0\n0 0 -1e-300\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST(WriteOff, WritesTheNormalsOfClouds) {
  const test::TemporaryFolder folder;
  Shape cloud = test::small_cloud();
  write_off(folder.path() / "t.off", cloud);
  EXPECT_EQ(test::bytes_of(folder.path() / "t.off"),
            "NOFF\n4 0 0\n0 0 0 0 0 -1\n1 0 0 1 0 0\n0 1 0 0 0 0\n0 0 1 -1 0 0\n");
  cloud.normals.resize(0, 3);
  write_off(folder.path() / "t.off", cloud);
  EXPECT_EQ(test::bytes_of(folder.path() / "t.off"), "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
}

TEST(ReadOff, RejectsFacesBeyondTheirCountAndIgnoresOtherTrailingData) {
  const std::string counts_and_vertices = "OFF\n4 1 0\n" + off_vertices;
  EXPECT_THAT(test::input_error_of([&] { read_off(counts_and_vertices + "3 0 1 2\n3 0 2 3\n", "t.off"); }),
              ::testing::HasSubstr("t.off:7: another face"));
  for (const std::string rest : {"", "1 2\n", "3 0 2 4\n", "0.5 0 0\n", "end\n"}) {
    EXPECT_EQ(read_off(counts_and_vertices + "3 0 1 2\n" + rest, "t.off").triangles.rows(), 1) << rest;
  }
}

}  // namespace

}  // namespace shapegauge
