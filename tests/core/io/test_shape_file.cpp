// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <gmock/gmock.h>
#include <limits>
#include <set>
#include <string>
#include <sys/stat.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::TemporaryFolder;
using test::tetrahedron;
using ::testing::StrEq;
using ::testing::ThrowsMessage;

/// Triangle corners, one per row. Unlike vertex order, their order is the same for formats without indices.
Points corners_of(const Shape& shape) {
  return shape.vertices(shape.triangles.reshaped<Eigen::RowMajor>(), Eigen::all);
}

using ReadShape = test::FolderTest;

TEST_F(ReadShape, ReadsEveryFormatByItsExtension) {
  for (const auto& [name, bytes, optional] : test::encoded_in_every_format(tetrahedron())) {
    const auto path = folder_.file(name, bytes);
    EXPECT_NO_THROW(check_shape_header(path));
    const Shape shape = read_shape(path);
    EXPECT_EQ(shape.vertices.rows(), 4) << name;
    EXPECT_EQ(corners_of(shape), corners_of(tetrahedron())) << name;
  }
}

TEST_F(ReadShape, ReadsCloudsWithNormalsInEveryFormat) {
  for (const auto& [name, bytes, optional] : test::cloud_in_every_format(test::small_cloud())) {
    SCOPED_TRACE(name);
    const auto path = folder_.file(name, bytes);
    EXPECT_NO_THROW(check_shape_header(path));
    test::expect_same(read_shape(path), test::small_cloud());
  }
}

TEST_F(ReadShape, ReadsTextInUtf16) {
  const std::string text = test::as_ascii_off(tetrahedron());
  std::string little = "\xFF\xFE";
  std::string big = "\xFE\xFF";
  for (const char character : text) {
    little += {character, '\0'};
    big += {'\0', character};
  }
  for (const auto& path : {folder_.file("little.off", little), folder_.file("big.off", big)}) {
    EXPECT_NO_THROW(check_shape_header(path));
    test::expect_same(read_shape(path), tetrahedron());
  }
}

TEST_F(ReadShape, AcceptsExtensionsInCapitals) {
  test::expect_same(read_shape(folder_.file("t.OFF", test::as_ascii_off(tetrahedron()))), tetrahedron());
}

TEST_F(ReadShape, DetectsTheFormatByTheFirstBytesIfTheExtensionIsUnknown) {
  test::expect_same(read_shape(folder_.file("T12", "C" + test::as_ascii_off(tetrahedron()))), tetrahedron());
  test::expect_same(read_shape(folder_.file("T13", "\xEF\xBB\xBF" + test::as_ascii_off(tetrahedron()))), tetrahedron());
  test::expect_same(read_shape(folder_.file("a.mesh", test::as_ascii_ply(tetrahedron()))), tetrahedron());
  EXPECT_EQ(read_shape(folder_.file("b.dat", test::as_ascii_stl(tetrahedron()))).triangles.rows(), 4);
  std::string of_off = test::as_ascii_stl(tetrahedron());
  of_off.insert(of_off.find('\n'), " OFF");  // in the name of the solid
  EXPECT_EQ(read_shape(folder_.file("c.dat", of_off)).triangles.rows(), 4);
}

TEST_F(ReadShape, SuggestsAConversionForUnsupportedFormats) {
  for (const char* name : {"part.STEP", "scene.fbx", "scan.las", "print.3mf"}) {
    test::write_text(folder_.path() / name, "anything");
    EXPECT_THAT(test::input_error_of([&] { read_shape(folder_.path() / name); }), ::testing::HasSubstr("export"));
  }
  EXPECT_FALSE(unsupported_format_advice("x.off"));
}

TEST_F(ReadShape, RejectsFoldersPipesEmptyUnreadableAndUnknownFiles) {
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
  std::filesystem::create_directory(at("folder.off"));
  ASSERT_EQ(::mkfifo(at("pipe.off").c_str(), 0644), 0);
  const auto locked = folder_.file("locked.off", test::as_ascii_off(tetrahedron()));
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  const std::vector<test::Refusal> refusals = {{"absent.off", "No such file"},
                                               {"folder.off", "folder"},
                                               {"pipe.off", "regular file"},
                                               {"locked.off", "Permission denied"},
                                               {folder_.file("empty.stl", "").filename(), "empty"},
                                               {folder_.file("empty", "").filename(), "empty"},
                                               {folder_.file("notes.doc", "hello\n").filename(), "\".doc\""}};
  const test::OrdinaryUser ordinary_user;
  test::expect_refused(refusals, [&](const std::string& name) { read_shape(folder_.path() / name); });
  test::expect_refused(refusals, [&](const std::string& name) { check_shape_header(folder_.path() / name); });
}

TEST_F(ReadShape, RejectsFilesWithoutVertices) {
  for (const auto& [name, bytes, optional] :
       {test::Encoded{"t.off", "OFF\n0 0 0\n"},
        {"t.ply",
         "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
         "property float z\nend_header\n"},
        {"t.pts", "0\n"},
        {"t.stl", "solid x\nendsolid x\n"},
        {"s.stl", std::string(84, '\0')}}) {
    const auto path = folder_.file(name, bytes);
    EXPECT_THAT([&] { read_shape(path); }, ThrowsMessage<InputError>(StrEq(path.string() + ": no vertices")));
  }
}

TEST_F(ReadShape, FindsTheHeaderAfterALongComment) {
  const std::string comment = "# " + std::string(200'000, 'x') + "\n";
  EXPECT_NO_THROW(check_shape_header(folder_.file("t.off", comment + test::as_ascii_off(tetrahedron()))));
  EXPECT_NO_THROW(check_shape_header(folder_.file("t.obj", comment + test::as_obj(tetrahedron()))));
  EXPECT_THROW(check_shape_header(folder_.file("u.off", comment + "hello")), InputError);
}

TEST(ShapeWriter, SelectsTheFormatByExtension) {
  const TemporaryFolder folder;
  for (const auto& [name, begin] : {std::pair{"t.off", "OFF"}, {"t.PLY", "ply"}, {"t.obj", "v 0"}, {"t.Stl", "bin"}}) {
    const auto path = folder.path() / name;
    shape_writer(path)(path, tetrahedron(), {});
    EXPECT_EQ(test::bytes_of(path).substr(0, 3), begin);
    EXPECT_NO_THROW(check_shape_header(path));
    EXPECT_EQ(corners_of(read_shape(path)), corners_of(tetrahedron())) << name;
  }
}

TEST(ShapeWriter, RejectsUnknownExtensions) {
  for (const char* const name : {"t.xyz", "t.doc", "t"}) EXPECT_THROW(shape_writer(name), InputError) << name;
}

TEST(ShapeWriter, RejectsInfiniteCoordinatesAndInvalidIndices) {
  const TemporaryFolder folder;
  Shape not_finite = tetrahedron();
  not_finite.vertices(2, 1) = std::numeric_limits<double>::infinity();
  Shape no_such_vertex = tetrahedron();
  no_such_vertex.triangles(0, 0) = 4;
  for (const std::string_view extension : written_shape_extensions()) {
    const auto path = folder.path() / ("t" + std::string(extension));
    EXPECT_THROW(shape_writer(path)(path, not_finite, {}), InputError) << extension;
    EXPECT_THROW(shape_writer(path)(path, no_such_vertex, {}), InputError) << extension;
    EXPECT_FALSE(std::filesystem::exists(path)) << extension;
  }
}

TEST(ShapeFormats, ExtensionsAreLowerCaseAndUnique) {
  std::set<std::string_view> seen;
  for (const std::string_view extension : shape_extensions()) {
    EXPECT_TRUE(extension.starts_with('.')) << extension;
    EXPECT_EQ(lower_case(std::string(extension)), extension);
    EXPECT_TRUE(seen.insert(extension).second) << extension;
  }
  for (const std::string_view extension : written_shape_extensions()) EXPECT_TRUE(seen.contains(extension));
  for (const ShapeFormat& format : shape_formats().entries()) {
    EXPECT_FALSE(format.name.empty());
    EXPECT_FALSE(format.description.empty()) << format.name;
  }
}

TEST(ShapeFormats, NamesOfModelsOmitTheExtension) {
  EXPECT_EQ(without_shape_extension("T12.off"), "T12");
  EXPECT_EQ(without_shape_extension("T12.PlY"), "T12");
  EXPECT_EQ(without_shape_extension("a.off.pwn"), "a.off");
  for (const std::string_view name : {"notes.txt", "T12", ".off", "off", "a.offs", "x.off/b", ""}) {
    EXPECT_EQ(without_shape_extension(name), name);
  }
}

/// Minimal format as a user of the library would add it.
TEST(RegisterShapeFormat, MakesAUserDefinedFormatReadable) {
  static constexpr std::array<std::string_view, 1> extensions{".point"};
  const ShapeFormat format{.name = "point",
                           .description = "Three bytes: a point",
                           .extensions = extensions,
                           .check_header =
                               [](const std::string& bytes, const std::string& name) {
                                 if (bytes.size() != 3) throw InputError(name + ": not three bytes");
                               },
                           .read =
                               [](const ShapeSource& source) {
                                 Shape shape;
                                 shape.vertices.resize(1, 3);
                                 for (int i = 0; i < 3; ++i) shape.vertices(0, i) = source.bytes.at(i) - '0';
                                 return shape;
                               }};
  shape_formats().add(format);
  const TemporaryFolder folder;
  EXPECT_EQ(read_shape(folder.file("a.Point", "123")).vertices, (Points(1, 3) << 1, 2, 3).finished());
  EXPECT_THROW(check_shape_header(folder.file("b.point", "12")), InputError);
  EXPECT_EQ(without_shape_extension("a.point"), "a");
  EXPECT_THROW(shape_writer("a.point"), InputError);
  EXPECT_THROW(shape_formats().add(format), InputError);
}

TEST(RegisterShapeFormat, RejectsFormatsWithoutReaderOrHeaderCheck) {
  ShapeFormat format = shape_formats().at("OFF");
  format.name = "test_unread";
  format.extensions = {};
  format.read = nullptr;
  EXPECT_THROW(shape_formats().add(format), ArgumentError);
  format.read = shape_formats().at("OFF").read;
  format.check_header = nullptr;
  EXPECT_THROW(shape_formats().add(format), ArgumentError);
}

}  // namespace

}  // namespace shapegauge
