#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/core/error.h"
#include "shapegauge/core/shape/validity.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

TEST(Validity, ShapesWithoutADefect) {
  EXPECT_EQ(defect_of(test_shapes::box({1, 2, 0}, 1)), std::nullopt);
  EXPECT_EQ(defect_of(Shape{}), std::nullopt);
  EXPECT_NO_THROW(require_usable(test_shapes::sphere(1e300, 1)));
}

TEST(Validity, NamesTheFirstVertexThatIsNotFinite) {
  Shape shape = test_shapes::box({1, 1, 1}, 1);
  shape.vertices(5, 2) = std::numeric_limits<double>::quiet_NaN();
  shape.vertices(3, 0) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(defect_of(shape), "vertex 3 has a coordinate that is not a finite number");
  EXPECT_THAT(
      [&] { require_usable(shape); },
      ThrowsMessage<InputError>(StrEq("the shape is unusable: vertex 3 has a coordinate that is not a finite number")));
}

TEST(Validity, NamesTheFirstTriangleWhoseVertexThereIsNot) {
  Shape shape = test_shapes::box({1, 1, 1}, 1);
  const auto vertices = static_cast<std::int32_t>(shape.vertices.rows());
  shape.triangles(7, 0) = -1;
  EXPECT_EQ(defect_of(shape), "triangle 7 has a vertex outside 0.." + std::to_string(vertices - 1));
  shape.triangles(4, 2) = vertices;
  EXPECT_EQ(defect_of(shape), "triangle 4 has a vertex outside 0.." + std::to_string(vertices - 1));
}

}  // namespace
}  // namespace shapegauge
