// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <gtest/gtest.h>
#include <optional>

#include "shapegauge/core/base/environment.h"

namespace shapegauge {
namespace {

TEST(EnvironmentVariable, DistinguishesUnsetFromEmptyValues) {
  const char* const name = "SHAPEGAUGE_TEST_OF_ENVIRONMENT";
  ASSERT_EQ(::unsetenv(name), 0);  // NOLINT(concurrency-mt-unsafe): one thread
  EXPECT_EQ(environment_variable(name), std::nullopt);
  ASSERT_EQ(::setenv(name, "", 1), 0);  // NOLINT(concurrency-mt-unsafe)
  EXPECT_EQ(environment_variable(name), "");
  ASSERT_EQ(::setenv(name, "/a b", 1), 0);  // NOLINT(concurrency-mt-unsafe)
  EXPECT_EQ(environment_variable(name), "/a b");
  ASSERT_EQ(::unsetenv(name), 0);  // NOLINT(concurrency-mt-unsafe)
}

}  // namespace
}  // namespace shapegauge
