// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/setting_names.h"

namespace shapegauge {

namespace {

TEST(SettingNames, InBackquotesAreReplacedByTheirSpellingInTheInterface) {
  const auto spelled = [](std::string_view message) {
    return spell_settings(message, [](std::string_view name, std::string_view value) {
      return "<" + std::string(name) + "|" + std::string(value) + ">";
    });
  };
  EXPECT_EQ(spelled("use `on_error=skip` or `replace`"), "use <on_error|skip> or <replace|>");
  EXPECT_EQ(spelled("`set=a.b=3`"), "<set|a.b=3>");
  EXPECT_EQ(spelled("no setting: `A b`, `` and `"), "no setting: `A b`, `` and `");
  EXPECT_EQ(spelled("`replace`: no (`part`, `ids`); `order`."), "<replace|>: no (<part|>, <ids|>); <order|>.");
  for (const char* file : {"a`b`c.off", "`ls`.off", "folder/`ls`", "x`y.off", "`offset=1`/m.off"}) {
    EXPECT_EQ(spelled(std::string("cannot read ") + file + ": use `replace`"),
              std::string("cannot read ") + file + ": use <replace|>");
  }
  EXPECT_EQ(spelled("`A b` and `ties=index`"), "`A b` and <ties|index>");
}

}  // namespace

}  // namespace shapegauge
