#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/write_off.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/core/io/temporary_folder.h"

namespace shapegauge {
namespace {

using test_io::tetrahedron;
using ::testing::EndsWith;
using ::testing::ThrowsMessage;

TEST(WriteOff, IsPlainOff) {
  const test_io::TemporaryFolder folder;
  Shape shape = tetrahedron();
  shape.vertices(1, 0) = 0.1;
  shape.vertices(3, 2) = -1e-300;
  write_off(folder.path() / "t.off", shape);
  EXPECT_EQ(test_io::bytes_of(folder.path() / "t.off"),
            "OFF\n4 4 0\n0 0 0\n0.1 0 0\n0 1 0\n0 0 -1e-300\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST(WriteOff, CloudsHaveTheirNormals) {
  const test_io::TemporaryFolder folder;
  Shape cloud = test_io::small_cloud();
  write_off(folder.path() / "t.off", cloud);
  EXPECT_EQ(test_io::bytes_of(folder.path() / "t.off"),
            "NOFF\n4 0 0\n0 0 0 0 0 -1\n1 0 0 1 0 0\n0 1 0 0 0 0\n0 0 1 -1 0 0\n");
  cloud.normals.resize(0, 3);
  write_off(folder.path() / "t.off", cloud);
  EXPECT_EQ(test_io::bytes_of(folder.path() / "t.off"), "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
}

TEST(WriteOff, NormalsThatCannotBeWrittenAreAnError) {
  const test_io::TemporaryFolder folder;
  Shape cloud = test_io::small_cloud();
  cloud.normals(0, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THAT([&] { write_off(folder.path() / "t.off", cloud); },
              ThrowsMessage<InputError>(EndsWith("a normal is not finite")));
  cloud.normals.conservativeResize(3, 3);
  EXPECT_THAT([&] { write_off(folder.path() / "t.off", cloud); },
              ThrowsMessage<InputError>(EndsWith("3 normals for 4 points")));
}

TEST(WriteOff, CoordinateThatIsNotFiniteIsAnError) {
  const test_io::TemporaryFolder folder;
  Shape shape = tetrahedron();
  shape.vertices(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { write_off(folder.path() / "t.off", shape); },
              ThrowsMessage<InputError>(EndsWith("vertex 2 has a coordinate that is not a finite number")));
  EXPECT_EQ(folder.size(), 0U);
}

TEST(WriteOff, VertexThatDoesNotExistIsAnError) {
  const test_io::TemporaryFolder folder;
  for (const int vertex : {-1, 4}) {
    Shape shape = tetrahedron();
    shape.triangles(3, 1) = vertex;
    EXPECT_THAT([&] { write_off(folder.path() / "t.off", shape); },
                ThrowsMessage<InputError>(EndsWith("triangle 3 has a vertex outside 0..3")));
  }
}

}  // namespace
}  // namespace shapegauge
