#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>
#include <set>

#include "shapegauge/experiments/results/file_names.h"

namespace shapegauge {
namespace {

using testing::ElementsAre;

TEST(FileSafeName, KeepsWhatIsSafe) {
  EXPECT_EQ(file_safe_name("Our SDF (d = 1%)"), "Our_SDF_d_1");
  EXPECT_EQ(file_safe_name("v1.2-b"), "v1.2-b");
  EXPECT_EQ(file_safe_name("a/../b"), "a_.._b");
  EXPECT_EQ(file_safe_name("../x"), "x");
  EXPECT_EQ(file_safe_name(".."), "unnamed");
  EXPECT_EQ(file_safe_name("中文"), "unnamed");
  EXPECT_EQ(file_safe_name(std::string(300, 'a')).size(), 100U);
}

TEST(FileSafeNames, AreDifferentEvenWithoutCase) {
  const std::vector<std::string> names{"a b", "a/b", "A?b", "a_b_2"};
  EXPECT_THAT(file_safe_names(names), ElementsAre("a_b", "a_b_2", "A_b_3", "a_b_2_2"));
}

RC_GTEST_PROP(FileSafeName, IsAPlainVisibleName, (const std::string& name)) {
  const std::string safe = file_safe_name(name);
  RC_ASSERT(!safe.empty());
  RC_ASSERT(safe.front() != '.');
  RC_ASSERT(safe.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") ==
            std::string::npos);
}

}  // namespace
}  // namespace shapegauge
