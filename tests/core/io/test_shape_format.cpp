// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <gtest/gtest.h>
#include <initializer_list>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_format.h"

namespace shapegauge {

namespace {

void add_face(SoupBuilder& builder, std::initializer_list<std::int32_t> corners) {
  builder.begin_face();
  for (const std::int32_t corner : corners) builder.add_corner(corner);
}

/// A builder with the corners of a square and, in its middle, a fifth vertex.
SoupBuilder square_builder() {
  SoupBuilder builder;
  for (const auto& vertex :
       {std::array{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {4.0, 4.0, 0.0}, {0.0, 4.0, 0.0}, {2.0, 1.0, 0.0}}) {
    builder.add_vertex(vertex);
  }
  return builder;
}

TEST(SoupBuilder, KeepsCloudNormalsOnlyIfThereIsOnePerPoint) {
  SoupBuilder cloud = square_builder();
  cloud.add_normal({0, 0, 5});
  cloud.add_normal({0, 0, 0});
  cloud.add_normal({3e300, 4e300, 0});
  cloud.add_normal({3e-300, 0, 4e-300});
  EXPECT_EQ(cloud.shape().normals.rows(), 0) << "one is missing";
  const double nearly_one = 1 + std::numeric_limits<double>::epsilon();
  cloud.add_normal({nearly_one, 0, 0});
  const Shape shape = cloud.shape();
  ASSERT_EQ(shape.normals.rows(), 5);
  EXPECT_EQ(shape.normals.row(0), Eigen::RowVector3d(0, 0, 1));
  EXPECT_EQ(shape.normals.row(1), Eigen::RowVector3d(0, 0, 0));
  EXPECT_TRUE(shape.normals.row(2).isApprox(Eigen::RowVector3d(0.6, 0.8, 0), 1e-15));
  EXPECT_TRUE(shape.normals.row(3).isApprox(Eigen::RowVector3d(0.6, 0, 0.8), 1e-15));
  EXPECT_EQ(shape.normals(4, 0), nearly_one) << "read as written";
  add_face(cloud, {0, 1, 2});
  EXPECT_EQ(cloud.shape().normals.rows(), 0) << "not of a mesh";
}

TEST(FirstLineOfData, SkipsBlanksAndComments) {
  EXPECT_EQ(first_line_of_data("\xEF\xBB\xBF\r\n # one\r\t\n  OFF 1 \nnext"), "OFF 1");
  EXPECT_EQ(first_line_of_data("OFF"), "OFF");
  EXPECT_EQ(first_line_of_data("a # b"), "a # b");
  EXPECT_EQ(first_line_of_data("# only\n\n"), "");
  EXPECT_EQ(first_line_of_data(""), "");
}

RC_GTEST_PROP(AppendNumber, WritesTheShortestTextThatIsReadBackExactly, (double number)) {
  std::string text = "x";
  append_number(text, number, ' ');
  RC_ASSERT(text.front() == 'x' && text.back() == ' ');
  double value = std::nan("");
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size() - 1, value);
  RC_ASSERT(error == std::errc() && end == text.data() + text.size() - 1);
  RC_ASSERT(value == number);
  RC_ASSERT(text.size() <= 26U);
}

TEST(AppendNumber, WritesNumbersOfMaximumTextLengthExactly) {
  for (const double number : {-std::numeric_limits<double>::max(), -std::numeric_limits<double>::denorm_min(),
                              -2.2250738585072014e-308, -1.7976931348623157e+308}) {
    std::string text;
    append_number(text, number, '\n');
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), number);
    EXPECT_EQ(text.back(), '\n');
  }
  std::string text;
  append_numbers(text, std::array{0.1F, -2.0F, 1e30F});
  EXPECT_EQ(text, "0.1 -2 1e+30\n");
}

TEST(RequireWritable, RejectsNonFiniteNumbersInvalidIndicesAndMissingNormals) {
  const Shape mesh{Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Triangles{{0, 1, 2}}};
  const Shape cloud{mesh.vertices, {}, mesh.vertices};
  EXPECT_NO_THROW(require_writable("x", mesh));
  EXPECT_NO_THROW(require_writable("x", cloud));
  Shape changed = mesh;
  changed.vertices(1, 2) = std::nan("");
  EXPECT_THROW(require_writable("x", changed), InputError);
  changed = mesh;
  changed.triangles(0, 1) = 3;
  EXPECT_THROW(require_writable("x", changed), InputError);
  changed.triangles(0, 1) = -1;
  EXPECT_THROW(require_writable("x", changed), InputError);
  changed = cloud;
  changed.normals(2, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(require_writable("x", changed), InputError);
  changed.normals = cloud.normals.topRows(2);
  EXPECT_THROW(require_writable("x", changed), InputError);
  changed.triangles = mesh.triangles;
  EXPECT_NO_THROW(require_writable("x", changed)) << "normals of a mesh are not written";
}

}  // namespace

}  // namespace shapegauge
