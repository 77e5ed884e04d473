// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::tetrahedron;

const std::string obj_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

void expect_obj_tetrahedron(const std::string& text) { test::expect_same(read_obj(text, "t.obj"), tetrahedron()); }

TEST(ReadObj, ReadsVerticesAndTrianglesOfAPlainFile) { expect_obj_tetrahedron(test::as_obj(tetrahedron())); }

TEST(ReadObj, AcceptsKeywordsInCapitals) {
  expect_obj_tetrahedron("V 0 0 0\nV 1 0 0\nV 0 1 \\\n0\nV 0 0 1\nVN 0 0 1\nF 1 3 \\\n2\nF 1 2 4\nF 1 4 3\nF 2 3 4\n");
  const std::string cloud = "V 0 0 0\nVN 0 0 1\n";
  EXPECT_EQ(read_obj(cloud, "t.obj").normals.rows(), 1);
  EXPECT_TRUE(is_recognised_shape({.bytes = cloud, .name = "standard input"}));
}

TEST(ReadObj, AcceptsTextureAndNormalIndices) {
  expect_obj_tetrahedron(obj_vertices +
                         "vt 0 0\nvn 0 0 1\nf 1/1/1 3/1 2//1\nf 1//1 2//1 4//1\nf 1/1 4/1 3/1\nf 2 3 4\n");
}

TEST(ReadObj, CountsNegativeIndicesFromTheLastVertex) {
  expect_obj_tetrahedron(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf -4//-1 -1/-2/-1 -2/-1\nf 2 3 4\n");
}

TEST(ReadObj, AcceptsFacesBeforeTheirVertices) {
  expect_obj_tetrahedron("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n" + obj_vertices);
}

TEST(ReadObj, IgnoresStatementsOtherThanVerticesAndFaces) {
  expect_obj_tetrahedron(
      "mtllib a b.mtl\no v\ng f 1\ns off\nusemtl f\nvp 0.1\n" + obj_vertices +
      "l 1 2\np 1\nsurf 0 1 0 1 1 2 3 4\ncurv 0 1 1 2 3\nf 1 3 2\nf 1 2 4\n# f 1 1 1\nf 1 4 3 # f\n\n  f 2 3 4");
}

TEST(ReadObj, IgnoresWeightsAndColoursAfterVertices) {
  expect_obj_tetrahedron(
      "v 0 0 0 1\nv 1 0 0 0.1 0.2 0.3\nv 0 1 0 1 0 0 1\nv 0 0 1 # x\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
}

TEST(ReadObj, JoinsLinesContinuedByABackslash) {
  expect_obj_tetrahedron(
      "v 0 \\\n 0 0\nv 1 0 0 \\\r\n1\nv 0 1 0\nv 0 0 1\nf 1 3 \\\n\\\n2\nf 1 2 4\nf 1 4 3\ng a \\\nf 1 1 1\nf 2 3 4");
}

TEST(ReadObj, AcceptsAByteOrderMarkAndCarriageReturns) {
  expect_obj_tetrahedron(
      "\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nv 0 0 1\r\nf 1 3 2\r\nf 1 2 4\r\nf 1 4 3\r\nf 2 3 4\r\n");
}

TEST(ReadObj, SplitsPolygonsIntoFansAndDropsFacesBelowThreeCorners) {
  const Shape shape = read_obj(obj_vertices + "f 4 3 2 1\nf 1 2\nf 1\nf\n", "t.obj");
  EXPECT_EQ(shape.triangles, (Triangles(2, 3) << 3, 2, 1, 3, 1, 0).finished());
}

TEST(ReadObj, FileWithoutFacesIsAPointCloud) {
  const Shape shape = read_obj(obj_vertices, "t.obj");
  EXPECT_EQ(shape.vertices, tetrahedron().vertices);
  EXPECT_EQ(shape.triangles.rows(), 0);
}

TEST(ReadObj, UsesNormalsOfACloudIfThereIsOnePerPoint) {
  const std::string normals = "vn 0 0 2\nvn 1 0 0\nvn 0 0 0\n";
  EXPECT_EQ(read_obj(obj_vertices + normals, "t.obj").normals.rows(), 0);
  const Shape shape = read_obj(normals + obj_vertices + "vn 0 -1 0\n", "t.obj");
  EXPECT_EQ(shape.normals, (Points(4, 3) << 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, -1, 0).finished());
}

TEST(ReadObj, IgnoresInvalidNormalsOfAMesh) {
  EXPECT_EQ(read_obj(obj_vertices + "vn 0 nan 0\nvn 1\nf 1 2 3\n", "t.obj").triangles.rows(), 1);
}

TEST(ReadObj, RefusesTextThatIsNotAMesh) {
  test::expect_refused({{obj_vertices + "f 1 2 3\nf 1 2 5\n", "t.obj:6: face 2 refers to vertex 5"},
                        {obj_vertices + "f 1 2 0\n", "t.obj:5: face 1 refers to vertex 0"},
                        {"v 0 0 0\nf -1 -1 -2\n", "t.obj:2: face 1 refers to vertex -2"},
                        {obj_vertices + "f 1 2 3000000000\n", "t.obj:5: face 1 refers to vertex 3000000000"},
                        {obj_vertices + "f 1 2 x\n", "t.obj:5: expected a vertex index"},
                        {obj_vertices + "f 1 2 1.5\n", "t.obj:5: expected a vertex index"},
                        {obj_vertices + "f 1 2 /1\n", "t.obj:5: expected a vertex index"},
                        {obj_vertices + "f 1 2 1x/2\n", "t.obj:5: expected a vertex index"},
                        {obj_vertices + "f 1 2 99999999999999999999\n", "t.obj:5: expected a vertex index"},
                        {"v 0 0 0\nv 1 nan 0\n", "t.obj:2: a coordinate is not a finite number"},
                        {"v 0 0 0\nv 1 x 0\n", "t.obj:2: expected a coordinate"},
                        {"v 0 0 0\nv 1 0\nv 0 0 1\n", "t.obj:2: vertex 2 has fewer"},
                        {obj_vertices + std::string(2, '\0') + "f 1 2 3\n", "t.obj:5: a zero byte"},
                        {obj_vertices + "vn 0 nan 0\n", "t.obj:5: a normal's component"},
                        {obj_vertices + "vn 0 0 1\nvn 1\n", "t.obj:6: normal 2 has fewer"},
                        {obj_vertices + "cstype bezier\ndeg 3\nsurf 0 1 0 1 1 2 3 4\nend\n", "free-form"},
                        {obj_vertices + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3\nend\n", "free-form"},
                        {obj_vertices + "cstype bezier\ndeg 3\ncurv2 1 2\nend\n", "free-form"},
                        {"# nothing\n", "no vertices"},
                        {obj_vertices + "f 1 2\n", "none of its 1 faces"}},
                       [](const std::string& text) { read_obj(text, "t.obj"); });
}

TEST(ReadObj, HeaderCheckRejectsTextWithoutVertices) {
  EXPECT_NO_THROW(obj_format().check_header("# v\no x\nv 0", "t.obj"));
  EXPECT_NO_THROW(obj_format().check_header("v\\\n0 0 0\n", "t.obj"));
  EXPECT_THROW(obj_format().check_header("# v 0 0 0\nvn 0 0 1\n", "t.obj"), InputError);
}

TEST(WriteObj, WritesVerticesAndFacesWithTheFewestPossibleDigits) {
  const test::TemporaryFolder folder;
  Shape shape = tetrahedron();
  shape.vertices(1, 0) = -1.5e-300;
  shape.vertices(3, 2) = 0.1;
  write_obj(folder.path() / "t.obj", shape);
  EXPECT_EQ(test::bytes_of(folder.path() / "t.obj"),
            "v 0 0 0\nv -1.5e-300 0 0\nv 0 1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
}

TEST(ReadObj, AcceptsFacesWithSignsTextureIndicesOrContinuedLines) {
  const Triangles expected = read_obj(obj_vertices + "f 1 2 3 4\n", "t.obj").triangles;
  for (const std::string faces : {"fo 1 2 3 4\n", "f +1 +2 +3 4\n", "f 1 2\\\n 3 4\n", "f 1 2 \\ \n 3 4\n",
                                  "f 1/1 2/2\\\r\n3/3 4/4\r\n", "usemtl C:\\mats\\\nf 1 2 3 4\n"}) {
    EXPECT_EQ(read_obj(obj_vertices + faces, "t.obj").triangles, expected) << faces;
  }
  EXPECT_EQ(read_obj("v 0 0\\\n 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "t.obj").vertices(0, 2), 1);
}

}  // namespace

}  // namespace shapegauge
