#include <gmock/gmock.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/core/io/write_shape.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/core/io/temporary_folder.h"

namespace shapegauge {
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
