#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "shapegauge/experiments/distributed/packing.h"

namespace shapegauge {

namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

TEST(Packing, GivesBackWhatWasAddedInTheSameOrder) {
  const std::string text("a\0b", 3);
  const std::vector<float> numbers{1.5F, -0.0F, std::numeric_limits<float>::infinity()};
  const Matrix matrix = Matrix::Random(3, 2);
  Packer packer;
  packer.add(std::int8_t{-7}).add(text).add(numbers).add(matrix).add(1e300).add(true);
  const std::string bytes = std::move(packer).bytes();

  Unpacker unpacker(bytes);
  std::string same_text;
  std::vector<float> same_numbers;
  Matrix same_matrix;
  EXPECT_EQ(unpacker.take_value<std::int8_t>(), -7);
  unpacker.take(same_text).take(same_numbers).take(same_matrix);
  EXPECT_EQ(same_text, text);
  EXPECT_EQ(same_numbers, numbers);
  EXPECT_TRUE(std::signbit(same_numbers[1]));
  EXPECT_EQ(same_matrix, matrix);
  EXPECT_EQ(unpacker.take_value<double>(), 1e300);
  EXPECT_FALSE(unpacker.is_at_end());
  EXPECT_TRUE(unpacker.take_value<bool>());
  EXPECT_TRUE(unpacker.is_at_end());
}

TEST(Packing, EmptyTextsListsAndMatrices) {
  Packer packer;
  packer.add(std::string_view()).add(std::vector<int>()).add(Matrix(0, 4)).add(std::uint64_t{9});
  const std::string bytes = std::move(packer).bytes();
  Unpacker unpacker(bytes);
  EXPECT_EQ(unpacker.take_value<std::string>(), "");
  EXPECT_TRUE(unpacker.take_value<std::vector<int>>().empty());
  const auto matrix = unpacker.take_value<Matrix>();
  EXPECT_EQ(matrix.rows(), 0);
  EXPECT_EQ(matrix.cols(), 4);
  EXPECT_EQ(unpacker.take_value<std::uint64_t>(), 9U);
  EXPECT_TRUE(unpacker.is_at_end());
}

}  // namespace

}  // namespace shapegauge
