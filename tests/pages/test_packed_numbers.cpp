// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/packed_numbers.h"

namespace shapegauge {
namespace {

std::string bytes_in_order(const std::vector<int>& numbers) {
  std::string bytes;
  for (const int number : numbers) bytes.push_back(static_cast<char>(number));
  return base64(bytes);
}

TEST(PackedShorts, AreWrittenInLittleEndianOrder) {
  EXPECT_EQ(packed_shorts({0, 1, 258, 65535}), bytes_in_order({0, 0, 1, 0, 2, 1, 255, 255}));
  EXPECT_EQ(packed_shorts({}), "");
}

TEST(PackedValues, AreSixteenBitLevelsBetweenMinimumAndMaximum) {
  const double infinity = std::numeric_limits<double>::infinity();
  // Level 65,534 is 0xfffe, its half 0x7fff; 0xffff is a missing value.
  EXPECT_EQ(packed_values(Eigen::VectorXd{{2, 4, 3, 1, std::nan(""), infinity}}, 2, 2),
            bytes_in_order({0, 0, 254, 255, 255, 127, 0, 0, 255, 255, 255, 255}));
}

}  // namespace
}  // namespace shapegauge
