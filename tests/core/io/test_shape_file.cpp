#include <gmock/gmock.h>
#include <string>
#include <sys/stat.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/core/io/ordinary_user.h"
#include "tests/core/io/temporary_folder.h"

namespace shapegauge {

namespace {

using test_io::TemporaryFolder;
using test_io::tetrahedron;
using ::testing::StrEq;
using ::testing::ThrowsMessage;

/// Both functions throw the same error.
void expect_error(const std::filesystem::path& path, const std::string& message) {
  EXPECT_THAT([&] { read_shape(path); }, ThrowsMessage<InputError>(StrEq(message)));
  EXPECT_THAT([&] { check_shape_header(path); }, ThrowsMessage<InputError>(StrEq(message)));
}

/// The corners of the triangles, one a row. The vertices' order differs where a format has no indices, theirs does not.
Points corners_of(const Shape& shape) {
  return shape.vertices(shape.triangles.reshaped<Eigen::RowMajor>(), Eigen::all);
}

TEST(ReadShape, EveryFormatByItsExtension) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes, optional] : test_io::encoded_in_every_format(tetrahedron())) {
    const auto path = folder.file(name, bytes);
    EXPECT_NO_THROW(check_shape_header(path));
    const Shape shape = read_shape(path);
    EXPECT_EQ(shape.vertices.rows(), 4) << name;
    EXPECT_EQ(corners_of(shape), corners_of(tetrahedron())) << name;
  }
}

TEST(ReadShape, CloudsWithTheirNormalsInEveryFormat) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes, optional] : test_io::cloud_in_every_format(test_io::small_cloud())) {
    SCOPED_TRACE(name);
    const auto path = folder.file(name, bytes);
    EXPECT_NO_THROW(check_shape_header(path));
    test_io::expect_same(read_shape(path), test_io::small_cloud());
  }
}

TEST(ReadShape, ExtensionInCapitals) {
  const TemporaryFolder folder;
  test_io::expect_same(read_shape(folder.file("t.OFF", test_io::as_ascii_off(tetrahedron()))), tetrahedron());
}

TEST(ReadShape, FormatByTheFirstBytesWhereTheExtensionIsUnknown) {
  const TemporaryFolder folder;
  test_io::expect_same(read_shape(folder.file("T12", "C" + test_io::as_ascii_off(tetrahedron()))), tetrahedron());
  test_io::expect_same(read_shape(folder.file("a.mesh", test_io::as_ascii_ply(tetrahedron()))), tetrahedron());
  EXPECT_EQ(read_shape(folder.file("b.dat", test_io::as_ascii_stl(tetrahedron()))).triangles.rows(), 4);
}

TEST(ReadShape, UnknownFormatIsAnError) {
  const TemporaryFolder folder;
  const auto path = folder.file("notes.doc", "hello\n");
  expect_error(path, path.string() +
                         ": unknown shape format \".doc\"; known are .off, .obj, .ply, .stl, .xyz, .pwn, "
                         ".pts, .txt");
}

TEST(ReadShape, AbsentFileIsAnError) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "absent.off";
  expect_error(path, "cannot read " + path.string() + ": No such file or directory");
}

TEST(ReadShape, FolderIsAnError) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "folder.off";
  std::filesystem::create_directory(path);
  expect_error(path, "cannot read " + path.string() + ": it is a folder");
}

TEST(ReadShape, PipeIsAnErrorAndDoesNotHang) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "pipe.off";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  expect_error(path, "cannot read " + path.string() + ": it is not a regular file");
}

TEST(ReadShape, FileWithoutPermissionIsAnError) {
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  const auto path = folder.file("t.off", test_io::as_ascii_off(tetrahedron()));
  std::filesystem::permissions(path, std::filesystem::perms::none);
  {
    const test_io::OrdinaryUser ordinary_user;
    expect_error(path, "cannot read " + path.string() + ": Permission denied");
  }
}

TEST(ReadShape, EmptyFileIsAnError) {
  const TemporaryFolder folder;
  for (const std::string extension : {".off", ".obj", ".ply", ".stl", ".xyz", ""}) {
    const auto path = folder.file("empty" + extension, "");
    expect_error(path, "cannot read " + path.string() + ": the file is empty");
  }
}

TEST(ReadShape, FileWithoutVerticesIsAnError) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes, optional] :
       {test_io::Encoded{"t.off", "OFF\n0 0 0\n"},
        {"t.ply",
         "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
         "property float z\nend_header\n"},
        {"t.pts", "0\n"},
        {"t.stl", "solid x\nendsolid x\n"},
        {"s.stl", std::string(84, '\0')}}) {
    const auto path = folder.file(name, bytes);
    EXPECT_THAT([&] { read_shape(path); }, ThrowsMessage<InputError>(StrEq(path.string() + ": it holds no vertex")));
  }
}

TEST(ReadShape, HeaderBehindALongCommentIsFound) {
  const TemporaryFolder folder;
  const std::string comment = "# " + std::string(200'000, 'x') + "\n";
  EXPECT_NO_THROW(check_shape_header(folder.file("t.off", comment + test_io::as_ascii_off(tetrahedron()))));
  EXPECT_NO_THROW(check_shape_header(folder.file("t.obj", comment + test_io::as_obj(tetrahedron()))));
  EXPECT_THROW(check_shape_header(folder.file("u.off", comment + "hello")), InputError);
}

}  // namespace

namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(ShapeWriter, WritesWhatTheExtensionSays) {
  const test_io::TemporaryFolder folder;
  for (const auto& [name, begin] : {std::pair{"t.off", "OFF"}, {"t.PLY", "ply"}}) {
    const auto path = folder.path() / name;
    shape_writer(path)(path, test_io::tetrahedron());
    EXPECT_EQ(test_io::bytes_of(path).substr(0, 3), begin);
    test_io::expect_same(read_shape(path), test_io::tetrahedron());
  }
}

TEST(ShapeWriter, RefusesAnotherExtension) {
  EXPECT_THAT([] { shape_writer("t.stl"); }, ThrowsMessage<InputError>(HasSubstr("t.stl: the name must end in")));
}

}  // namespace

}  // namespace shapegauge
