#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/metrics/protocol.h"

namespace shapegauge {
namespace {

TEST(Protocol, HasItsNamesBothWays) {
  EXPECT_THAT(protocol_names(), testing::ElementsAre("psb", "paper", "trec"));
  for (const std::string& name : protocol_names()) {
    const auto protocol = protocol_of(name);
    ASSERT_TRUE(protocol) << name;
    EXPECT_EQ(name_of(*protocol), name);
  }
  EXPECT_EQ(protocol_of("psb"), Protocol::psb);
  EXPECT_EQ(protocol_of("paper"), Protocol::paper);
}

TEST(Protocol, OtherNamesMeanNothing) {
  EXPECT_FALSE(protocol_of(""));
  EXPECT_FALSE(protocol_of("PSB"));
  EXPECT_FALSE(protocol_of("psb "));
}

}  // namespace
}  // namespace shapegauge
