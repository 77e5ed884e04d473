#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/off.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::expect_same;
using test::tetrahedron;
using ::testing::StrEq;
using ::testing::ThrowsMessage;

const std::string off_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string off_faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

void expect_off_tetrahedron(const std::string& text) { expect_same(read_off(text, "t.off"), tetrahedron()); }

void expect_off_error(const std::string& text, const std::string& message) {
  EXPECT_THAT([&] { read_off(text, "t.off"); }, ThrowsMessage<InputError>(StrEq(message))) << text;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

TEST(ReadOff, Plain) { expect_off_tetrahedron("OFF\n4 4 6\n" + off_vertices + off_faces); }
TEST(ReadOff, KeywordMissing) { expect_off_tetrahedron("4 4 6\n" + off_vertices + off_faces); }
TEST(ReadOff, KeywordInLowerCase) { expect_off_tetrahedron("off\n4 4 6\n" + off_vertices + off_faces); }
TEST(ReadOff, CountsOnTheLineOfTheKeyword) { expect_off_tetrahedron("OFF 4 4 6\n" + off_vertices + off_faces); }
TEST(ReadOff, CountsGluedToTheKeyword) { expect_off_tetrahedron("OFF4 4 6\n" + off_vertices + off_faces); }
TEST(ReadOff, CountsGluedToALongerKeyword) { expect_off_tetrahedron("COFF4 4 6\n" + off_vertices + off_faces); }
TEST(ReadOff, CountsOnALineEach) { expect_off_tetrahedron("OFF\n4\n4\n6\n" + off_vertices + off_faces); }
TEST(ReadOff, WrongNumberOfEdges) { expect_off_tetrahedron("OFF\n4 4 -17\n" + off_vertices + off_faces); }
TEST(ReadOff, NumberOfEdgesMissing) { expect_off_tetrahedron("OFF\n4 4\n" + off_vertices + off_faces); }
TEST(ReadOff, NumberOfEdgesThatIsNoNumber) { expect_off_tetrahedron("OFF\n4 4 ?\n" + off_vertices + off_faces); }

TEST(ReadOff, CommentsAndBlankLinesAnywhere) {
  expect_off_tetrahedron(
      "# before\n\nOFF# behind the keyword\n#\n4 4 6 # behind the counts\n\n  # indented\n0 0 0#glued\n1 0 0 # v 1\n\n"
      "0 1 0\n#between\n0 0 1\n\n# faces\n3 0 2 1 # f 0\n3 0 1 3\n\t\n3 0 3 2\n3 1 2 3 # the last line has no end");
}

TEST(ReadOff, CommentWithinARecord) {
  expect_off_tetrahedron("OFF\n4 4 6\n0 # x\n0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 # then\n2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST(ReadOff, LinesEndWithCarriageReturnAndLineFeed) {
  expect_off_tetrahedron(replaced("OFF\n4 4 6\n" + off_vertices + off_faces, "\n", "\r\n"));
}

TEST(ReadOff, LinesEndWithCarriageReturn) {
  expect_off_tetrahedron(replaced("OFF\n# comment\n4 4 6\n" + off_vertices + off_faces, "\n", "\r"));
}

TEST(ReadOff, ByteOrderMark) { expect_off_tetrahedron("\xEF\xBB\xBFOFF\n4 4 6\n" + off_vertices + off_faces); }
TEST(ReadOff, LastLineWithoutEnd) {
  expect_off_tetrahedron("OFF\n4 4 6\n" + off_vertices + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3");
}

TEST(ReadOff, TabsAndManySpaces) {
  expect_off_tetrahedron(replaced("OFF\n4 4 6\n" + off_vertices + off_faces, " ", " \t  "));
}

TEST(ReadOff, Exponents) {
  const Shape shape = read_off("OFF\n2 0 0\n1e2 -1.5E-3 +2.5e+1\n.5 5. 1e-400\n", "t.off");
  EXPECT_EQ(shape.vertices, (Points(2, 3) << 100, -0.0015, 25, 0.5, 5, 0).finished());
}

TEST(ReadOff, ColoursNormalsAndTextureAfterVertices) {
  const std::vector<std::string> extras = {" 255 0 0 255", " 0.1 0.2 0.3", " 0 0 1", " 0.5 0.5",
                                           " 0 0 1 255 0 0 255 0.5 0.5"};
  for (const std::string keyword : {"COFF", "NOFF", "STOFF", "CNOFF", "NCOFF", "STCOFF", "STNOFF", "STCNOFF", "OFF"}) {
    for (const std::string& extra : extras) {
      expect_off_tetrahedron(keyword + "\n4 4 6\n" + replaced(off_vertices, "\n", extra + "\n") + off_faces);
    }
  }
}

TEST(ReadOff, ColoursAfterFaces) {
  for (const std::string colour : {" 7", " 255 0 0", " 0.1 0.2 0.3 1", " 3 255 0 0", " # red"}) {
    expect_off_tetrahedron("OFF\n4 4 6\n" + off_vertices + replaced(off_faces, "\n", colour + "\n"));
  }
}

TEST(ReadOff, DataAfterTheLastFace) { expect_off_tetrahedron("OFF\n4 4 6\n" + off_vertices + off_faces + "SKEL {}\n"); }
TEST(ReadOff, PaddingAfterTheLastFace) {
  expect_off_tetrahedron("OFF\n4 4 6\n" + off_vertices + off_faces + std::string(9, '\0'));
}

TEST(ReadOff, EverythingOnOneLine) {
  expect_off_tetrahedron(replaced("OFF\n4 4 6\n" + off_vertices + off_faces, "\n", " "));
}

TEST(ReadOff, EverythingOnOneLineWithExtras) {
  expect_off_tetrahedron(replaced("COFF\n4 4 6\n" + replaced(off_vertices, "\n", " 1 0 0 1\n") + off_faces, "\n", " "));
}

TEST(ReadOff, OneNumberOnALine) {
  expect_off_tetrahedron(replaced("OFF\n4 4 6\n" + off_vertices + off_faces, " ", "\n"));
}

TEST(ReadOff, PolygonsBecomeFans) {
  const Shape shape =
      read_off("OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 2 0\n5 0 1 2 4 3 255 0 0\n4 3 2 1 0\n", "t.off");
  EXPECT_EQ(shape.triangles, (Triangles(5, 3) << 0, 1, 2, 0, 2, 4, 0, 4, 3, 3, 2, 1, 3, 1, 0).finished());
}

TEST(ReadOff, FacesOfFewerThanThreeVerticesLeaveNoTriangle) {
  expect_off_tetrahedron("OFF\n4 7 6\n" + off_vertices + "0\n2 0 1\n1 3\n" + off_faces);
}

TEST(ReadOff, OnlyFacesOfFewerThanThreeVerticesAreAnErrorAndNoCloud) {
  expect_off_error("OFF\n4 2 6\n" + off_vertices + "2 0 1\n1 3\n", "t.off: none of its 2 faces has three vertices");
}

TEST(ReadOff, NonManifoldDegenerateAndDuplicateFacesAndUnusedVerticesSurvive) {
  const Shape shape = read_off(
      "OFF\n6 7 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n9 9 9\n"
      "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 0 1\n3 2 2 2\n3 0 1 2\n3 2 1 0\n",
      "t.off");
  EXPECT_EQ(shape.vertices.rows(), 6);
  EXPECT_EQ(shape.triangles,
            (Triangles(7, 3) << 0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 0, 1, 2, 2, 2, 0, 1, 2, 2, 1, 0).finished());
}

TEST(ReadOff, WithoutFacesItIsAPointCloud) {
  const Shape shape = read_off("OFF\n4 0 0\n" + off_vertices, "t.off");
  EXPECT_EQ(shape.vertices, tetrahedron().vertices);
  EXPECT_EQ(shape.triangles.rows(), 0);
}

TEST(ReadOff, NormalsOfACloudAreThoseThatTheKeywordAnnounces) {
  const std::string lines = "0 0 0 0 0 2 9 9 9 9\n1 0 0 0 0 0 9 9 9 9\n";
  const Points expected = (Points(2, 3) << 0, 0, 1, 0, 0, 0).finished();
  for (const std::string& text :
       {"NOFF\n2 0 0\n" + lines, "NCOFF\n2 0 0\n" + lines, replaced("CNOFF\n2 0 0\n" + lines, "\n", " ")}) {
    EXPECT_EQ(read_off(text, "t.off").normals, expected) << text;
  }
  EXPECT_EQ(read_off("OFF\n2 0 0\n" + lines, "t.off").normals.rows(), 0);
  EXPECT_EQ(read_off("NOFF\n4 0 0\n" + off_vertices, "t.off").normals.rows(), 0);
  expect_off_error("NOFF\n2 0 0\n0 0 0 0 0 1\n1 0 0 0 nan 0\n",
                   "t.off:4: a normal's component is not a finite number: \"nan\"; repair or remove the file");
  expect_off_error("NOFF\n2 0 0\n0 0 0 0 0 1\n1 0 0\n",
                   "t.off:4: the normal of vertex 1 has fewer than three components");
  expect_off_error("NOFF\n2 0 0\n0 0 0 0 0 1\n1 0 0 0 1\n",
                   "t.off:4: the normal of vertex 1 has fewer than three components");
}

TEST(ReadOff, NormalsOfAMeshMayBeAnything) {
  expect_off_tetrahedron("NOFF\n4 4 6\n" + replaced(off_vertices, "\n", " nan x\n") + off_faces);
}

TEST(ReadOff, BinaryNormalThatIsNotFinite) {
  Shape cloud = test::small_cloud();
  cloud.normals(1, 1) = std::numeric_limits<double>::infinity();
  const auto files = test::cloud_in_every_format(cloud);
  const auto binary = std::ranges::find(files, "binary.off", &test::Encoded::file_name);
  expect_off_error(binary->bytes,
                   "t.off: vertex 1 has a normal that is not a finite number; repair or remove the file");
}

TEST(ReadOff, Binary) { expect_same(read_off(test::as_binary_off(tetrahedron()), "t.off"), tetrahedron()); }

TEST(ReadOff, BinaryWithExtras) {
  expect_same(read_off(test::as_binary_off(tetrahedron(), "COFF BINARY # a comment\r\n", 4), "t.off"), tetrahedron());
  expect_same(read_off(test::as_binary_off(tetrahedron(), "STCNOFF  BINARY\n", 9), "t.off"), tetrahedron());
}

TEST(ReadOff, BinaryIndexOutOfRange) {
  Shape shape = tetrahedron();
  shape.triangles(2, 1) = 4;
  expect_off_error(test::as_binary_off(shape),
                   "t.off: face 2 refers to vertex 4, but the vertices are numbered 0 to 3");
}

TEST(ReadOff, BinaryCoordinateThatIsNotFinite) {
  Shape shape = tetrahedron();
  shape.vertices(3, 0) = std::numeric_limits<double>::infinity();
  expect_off_error(test::as_binary_off(shape),
                   "t.off: vertex 3 has a coordinate that is not a finite number; repair or remove the file");
}

TEST(ReadOff, BinaryTruncated) {
  const std::string bytes = test::as_binary_off(tetrahedron());
  expect_off_error(bytes.substr(0, 20), "t.off: ends before the numbers of vertices, faces and edges");
  expect_off_error(bytes.substr(0, 70),
                   "t.off: ends after 3 of 4 vertices; the file is truncated or its header is wrong");
  expect_off_error(bytes.substr(0, bytes.size() - 1),
                   "t.off: ends after 3 of 4 faces; the file is truncated or its header is wrong");
}

TEST(ReadOff, OtherDimensionsAreAnError) {
  for (const std::string keyword : {"4OFF", "nOFF", "C4nOFF"}) {
    expect_off_error(keyword + "\n4\n4 4 6\n" + off_vertices + off_faces,
                     "t.off:1: 4OFF and nOFF files have points of other than three dimensions; convert it to OFF");
  }
}

TEST(ReadOff, SomethingElseIsAnError) {
  for (const std::string text : {"ply\nformat ascii 1.0\n", "solid x\n", "OFFX 1 2 3\n", "-4 4 6\n", "\xFF\xFEO\n"}) {
    expect_off_error("\n" + text, "t.off:2: not an OFF file: expected the keyword OFF or the number of vertices");
  }
  expect_off_error("# nothing\n\n", "t.off: contains only white space and comments");
}

TEST(ReadOff, UnusableCountsAreAnError) {
  expect_off_error("OFF\n", "t.off: ends before the numbers of vertices and faces");
  expect_off_error("OFF\n4", "t.off: ends before the numbers of vertices and faces");
  expect_off_error("OFF\n4 -1 6\n", "t.off:2: 4 vertices and -1 faces: numbers must not be negative");
  expect_off_error("OFF\n3000000000 1 0\n",
                   "t.off:2: 3000000000 vertices and 1 faces: at most 2147483647 of each can be read");
  expect_off_error("OFF\nfour 4 6\n", "t.off:2: expected the number of vertices (a whole number), found \"four\"");
  expect_off_error("OFF\n4.5 4 6\n", "t.off:2: expected the number of vertices (a whole number), found \"4.5\"");
  expect_off_error("OFF\n99999999999999999999 4 6\n",
                   "t.off:2: expected the number of vertices (a whole number), found \"99999999999999999999\"");
}

TEST(ReadOff, TruncatedVertices) {
  expect_off_error("OFF\n4 4 6\n0 0 0\n1 0 0\n0 1",
                   "t.off: ends after 2 of 4 vertices; the file is truncated or its header is wrong");
}

TEST(ReadOff, TruncatedFaces) {
  for (const std::string end : {"", "3", "3 0 3\n"}) {
    expect_off_error("OFF\n4 4 6\n" + off_vertices + "3 0 2 1 255 0 0\n3 0 1 3 0 0 0\n" + end,
                     "t.off: ends after 2 of 4 faces; the file is truncated or its header is wrong");
  }
}

TEST(ReadOff, MissingCoordinatesAreNotTakenFromTheNextLineSilently) {
  expect_off_error("OFF\n4 4 6\n0 0\n1 0\n0 1\n1 1\n" + off_faces,
                   "t.off: ends after 2 of 4 faces; the file is truncated or its header is wrong");
}

TEST(ReadOff, IndexOutOfRange) {
  expect_off_error("OFF\n4 4 6\n" + off_vertices + replaced(off_faces, "0 1 3", "0 1 4"),
                   "t.off:8: face 1 refers to vertex 4, but the vertices are numbered 0 to 3");
  expect_off_error(replaced("OFF\n4 4 6\n" + off_vertices + replaced(off_faces, "0 1 3", "0 -1 3"), "\n", "\r\n"),
                   "t.off:8: face 1 refers to vertex -1, but the vertices are numbered 0 to 3");
}

TEST(ReadOff, FaceWithoutAUsableNumberOfVertices) {
  expect_off_error("OFF\n4 4 6\n" + off_vertices + "-3 0 1 2\n", "t.off:7: face 0 cannot have -3 vertices");
  expect_off_error("OFF\n4 4 6\n" + off_vertices + "3.5 0 1 2\n",
                   "t.off:7: expected a face's number of vertices (a whole number), found \"3.5\"");
  expect_off_error("OFF\n4 1 6\n" + off_vertices + "2000000000 0 1 2\n",
                   "t.off:7: face 0 has more than 100000 vertices; triangulate it");
  expect_off_error("OFF\n4 1 6\n" + off_vertices + "90000 0 1 2\n",
                   "t.off: ends after 0 of 1 faces; the file is truncated or its header is wrong");
}

TEST(ReadOff, CoordinateThatIsNotFinite) {
  for (const std::string number : {"nan", "NaN", "-nan", "inf", "-Infinity", "1e400", "-1e999999"}) {
    expect_off_error("OFF\n4 4 6\n0 0 0\n1 0 " + number + "\n",
                     "t.off:4: a coordinate is not a finite number: \"" + number + "\"; repair or remove the file");
  }
}

TEST(ReadOff, CoordinateThatIsNoNumber) {
  for (const std::string word : {"x", "0,5", "1.#QNAN", "-1.#IND", "0x10", "1e", "1.5.2", "+-1", "--1", "-", "1,"}) {
    expect_off_error("OFF\n4 4 6\n0 0 0\n1 0 " + word + "\n", "t.off:4: expected a coordinate, found \"" + word + "\"");
  }
}

TEST(ReadOff, AWordThatIsNoTextIsShownInPartAndOnOneLine) {
  expect_off_error("OFF\n1 0 0\n0 0 \x01" + std::string(1000, '\x7F') + "\n",
                   "t.off:3: expected a coordinate, found \"" + std::string(270, '?') + "...");
}

TEST(ReadOff, HeaderAloneCanBeChecked) {
  EXPECT_NO_THROW(check_off_header("OFF\n4 4 6\n", "t.off"));
  EXPECT_NO_THROW(check_off_header("OFF BINARY\n", "t.off"));
  EXPECT_THROW(check_off_header("OFF\n", "t.off"), InputError);
  EXPECT_THROW(check_off_header("HELLO\n4 4 6\n", "t.off"), InputError);
}

using test::tetrahedron;
using ::testing::EndsWith;

TEST(WriteOff, IsPlainOff) {
  const test::TemporaryFolder folder;
  Shape shape = tetrahedron();
  shape.vertices(1, 0) = 0.1;
  shape.vertices(3, 2) = -1e-300;
  write_off(folder.path() / "t.off", shape);
  EXPECT_EQ(test::bytes_of(folder.path() / "t.off"),
            "OFF\n4 4 0\n0 0 0\n0.1 0 0\n0 1 0\n0 0 -1e-300\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST(WriteOff, CloudsHaveTheirNormals) {
  const test::TemporaryFolder folder;
  Shape cloud = test::small_cloud();
  write_off(folder.path() / "t.off", cloud);
  EXPECT_EQ(test::bytes_of(folder.path() / "t.off"),
            "NOFF\n4 0 0\n0 0 0 0 0 -1\n1 0 0 1 0 0\n0 1 0 0 0 0\n0 0 1 -1 0 0\n");
  cloud.normals.resize(0, 3);
  write_off(folder.path() / "t.off", cloud);
  EXPECT_EQ(test::bytes_of(folder.path() / "t.off"), "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
}

TEST(WriteOff, NormalsThatCannotBeWrittenAreAnError) {
  const test::TemporaryFolder folder;
  Shape cloud = test::small_cloud();
  cloud.normals(0, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THAT([&] { write_off(folder.path() / "t.off", cloud); },
              ThrowsMessage<InputError>(EndsWith("a normal is not finite")));
  cloud.normals.conservativeResize(3, 3);
  EXPECT_THAT([&] { write_off(folder.path() / "t.off", cloud); },
              ThrowsMessage<InputError>(EndsWith("3 normals for 4 points")));
}

TEST(WriteOff, CoordinateThatIsNotFiniteIsAnError) {
  const test::TemporaryFolder folder;
  Shape shape = tetrahedron();
  shape.vertices(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { write_off(folder.path() / "t.off", shape); },
              ThrowsMessage<InputError>(EndsWith("vertex 2 has a coordinate that is not a finite number")));
  EXPECT_EQ(folder.size(), 0U);
}

TEST(WriteOff, VertexThatDoesNotExistIsAnError) {
  const test::TemporaryFolder folder;
  for (const int vertex : {-1, 4}) {
    Shape shape = tetrahedron();
    shape.triangles(3, 1) = vertex;
    EXPECT_THAT([&] { write_off(folder.path() / "t.off", shape); },
                ThrowsMessage<InputError>(EndsWith("triangle 3 has a vertex outside 0..3")));
  }
}

TEST(ReadOff, AFaceAfterTheLastIsAWrongCountAndOtherDataIsIgnored) {
  const std::string counts_and_vertices = "OFF\n4 1 0\n" + off_vertices;
  expect_off_error(counts_and_vertices + "3 0 1 2\n3 0 2 3\n",
                   "t.off:7: another face after the last of 1: the numbers of vertices and faces are wrong");
  for (const std::string rest : {"", "1 2\n", "3 0 2 4\n", "0.5 0 0\n", "end\n"}) {
    EXPECT_EQ(read_off(counts_and_vertices + "3 0 1 2\n" + rest, "t.off").triangles.rows(), 1) << rest;
  }
}

}  // namespace

}  // namespace shapegauge
