// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/core/base/members.h"
#include "shapegauge/experiments/cache/codec.h"

namespace shapegauge {

namespace {

enum class Kind { one, two };

struct Inner {
  double number = 0;
  std::string text;
};

struct Outer {
  Kind kind = Kind::one;
  std::optional<Inner> inner;
  std::vector<Inner> list;
  std::map<std::string, std::size_t> counts;
  std::vector<float> numbers;
  Eigen::MatrixXd matrix;
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> points;
};

SHAPEGAUGE_MEMBERS(Inner, number, text)

SHAPEGAUGE_MEMBERS(Outer, kind, inner, list, counts, numbers, matrix, points)

Outer sample() {
  return {
      .kind = Kind::two,
      .inner = Inner{.number = std::numeric_limits<double>::quiet_NaN(), .text = std::string("a\0b", 3)},
      .list = {{.number = -0.0, .text = ""}, {.number = 5e-324, .text = "longer than a short string of the library"}},
      .counts = {{"hit", 3}, {"missed", 0}},
      .numbers = {1.5F, -2},
      .matrix = Eigen::MatrixXd::Random(3, 2),
      .points = Eigen::MatrixXf::Random(4, 3)};
}

TEST(BinaryCodec, RestoresEveryBitOfEncodedValues) {
  const Outer before = sample();
  const auto after = decode<Outer>(encode(before));
  EXPECT_EQ(after.kind, Kind::two);
  EXPECT_TRUE(std::isnan(after.inner.value().number));
  EXPECT_EQ(after.inner->text, before.inner->text);
  ASSERT_EQ(after.list.size(), 2U);
  EXPECT_TRUE(std::signbit(after.list[0].number));
  EXPECT_EQ(after.list[1].number, 5e-324);
  EXPECT_EQ(after.list[1].text, before.list[1].text);
  EXPECT_EQ(after.counts, before.counts);
  EXPECT_EQ(after.numbers, before.numbers);
  EXPECT_EQ(after.matrix, before.matrix);
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(encode(after), encode(before));
}

TEST(BinaryCodec, RestoresEmptyValues) {
  const auto after = decode<Outer>(encode(Outer()));
  EXPECT_FALSE(after.inner);
  EXPECT_EQ(after.matrix.size() + after.points.size() + std::ssize(after.list), 0);
}

TEST(BinaryCodec, RejectsMissingAndTrailingBytes) {
  const std::string bytes = encode(sample());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(decode<Outer>(std::string_view(bytes).substr(0, length)), DamagedBytes) << length;
  }
  EXPECT_THROW(decode<Outer>(bytes + "x"), DamagedBytes);
}

TEST(BinaryCodec, RejectsAnElementCountLargerThanTheRemainingBytes) {
  const std::string many = encode(std::numeric_limits<std::size_t>::max());
  EXPECT_THROW(decode<std::vector<double>>(many), DamagedBytes);
  EXPECT_THROW(decode<std::string>(many), DamagedBytes);
  EXPECT_THROW((decode<std::map<std::string, double>>(many)), DamagedBytes);
  EXPECT_THROW(decode<Eigen::MatrixXd>(encode(std::vector<Eigen::Index>{Eigen::Index{1} << 40})), DamagedBytes);
}

}  // namespace

}  // namespace shapegauge
