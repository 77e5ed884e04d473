#include <cmath>
#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/experiments/report/packed_values.h"

namespace shapegauge {
namespace {

TEST(Base64, AsInTheRfc) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, ALongTextIsEncodedInOnePiece) {
  const std::string text = base64(std::string(7 << 20, '\0'));
  EXPECT_EQ(text.size(), 4U * (((7 << 20) + 2) / 3));
  EXPECT_EQ(text.find('='), text.size() - 2);
}

TEST(PackedValues, TwoBytesEachOfTheLargest) {
  const double infinity = std::numeric_limits<double>::infinity();
  const nlohmann::ordered_json json = packed(Eigen::VectorXd{{0, 3, 1.5, infinity, std::nan(""), -1}});
  EXPECT_EQ(json["scale"], 3);
  // 0, 65534, 32767, 65535, 65535, 0
  EXPECT_EQ(json["values"], base64(std::string("\0\0\xfe\xff\xff\x7f\xff\xff\xff\xff\0\0", 12)));
}

TEST(PackedValues, AllZeroOrNothing) {
  EXPECT_EQ(packed(Eigen::VectorXd{{0, 0}})["scale"], 1);
  EXPECT_EQ(packed(Eigen::VectorXd(0))["values"], "");
}

TEST(Rounded, KeepsTheLeadingDigits) {
  EXPECT_EQ(rounded(0.123456789, 3), 0.123);
  EXPECT_EQ(rounded(98765.4321, 3), 98800);
  EXPECT_TRUE(std::isinf(rounded(std::numeric_limits<double>::infinity(), 3)));
}

}  // namespace
}  // namespace shapegauge
