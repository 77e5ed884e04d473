#include <gtest/gtest.h>

#include "shapegauge/experiments/text/lower_case.h"

namespace shapegauge {
namespace {

TEST(LowerCase, ChangesTheCapitalsOfAsciiAlone) {
  EXPECT_EQ(lower_case(".OFF"), ".off");
  EXPECT_EQ(lower_case("AZaz09@[`{ -"), "azaz09@[`{ -");
  EXPECT_EQ(lower_case("\xC3\x89"), "\xC3\x89");
  EXPECT_EQ(lower_case(""), "");
}

}  // namespace
}  // namespace shapegauge
