// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/core/base/little_endian.h"

namespace shapegauge {

namespace {

TEST(LittleEndian, AppendsTheLeastSignificantByteFirst) {
  using namespace std::string_literals;
  std::string bytes = "x";
  append_little_endian(bytes, std::uint8_t{0xFE});
  append_little_endian(bytes, std::int16_t{-2});
  append_little_endian(bytes, std::uint32_t{0x01020304});
  append_little_endian(bytes, 1.0F);
  append_little_endian(bytes, -2.0);
  EXPECT_EQ(bytes, "x\xFE"s + "\xFE\xFF"s + "\x04\x03\x02\x01"s + "\0\0\x80\x3F"s + "\0\0\0\0\0\0\0\xC0"s);
}

}  // namespace

}  // namespace shapegauge
