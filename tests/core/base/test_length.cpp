// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/length.h"

namespace shapegauge {
namespace {

TEST(LengthOption, IsANumberWithOrWithoutAUnit) {
  EXPECT_EQ(parse_length("2")->value, 2);
  EXPECT_EQ(parse_length("2")->unit, "");
  EXPECT_EQ(parse_length("0.5mm")->value, 0.5);
  EXPECT_EQ(parse_length("0.5mm")->unit, "mm");
  EXPECT_EQ(parse_length("1e-3 in")->value, 1e-3);
  EXPECT_EQ(parse_length("1e-3 in")->unit, "in");
  for (const char* wrong : {"", "mm", "2 parsecs", "two", "2mm3", "inf", "nan mm", "1 2"}) {
    EXPECT_FALSE(parse_length(wrong)) << wrong;
  }
}

TEST(LengthOption, IsConvertedToTheUnitOfTheFile) {
  EXPECT_DOUBLE_EQ(in_file_units("--below", {2, "mm"}, "mm"), 2);
  EXPECT_DOUBLE_EQ(in_file_units("--below", {2, "mm"}, "m"), 0.002);
  EXPECT_DOUBLE_EQ(in_file_units("--below", {1, "in"}, "mm"), 25.4);
  EXPECT_DOUBLE_EQ(in_file_units("--below", {3, ""}, ""), 3);
  EXPECT_THROW(in_file_units("--below", {2, "mm"}, ""), InputError);
  EXPECT_THROW(in_file_units("--below", {2, "mm"}, "ells"), InputError);
}

}  // namespace
}  // namespace shapegauge
