#include <gtest/gtest.h>

#include "shapegauge/core/base/setting_names.h"

namespace shapegauge {

namespace {

TEST(SettingNames, AreOptionsOnTheCommandLineAndArgumentsInPython) {
  EXPECT_EQ(setting_name(Audience::command_line, "minimum_class_size"), "--minimum-class-size");
  EXPECT_EQ(setting_name(Audience::python, "minimum_class_size"), "minimum_class_size");
  EXPECT_EQ(setting_with_word(Audience::command_line, "ties", "index"), "--ties index");
  EXPECT_EQ(setting_with_word(Audience::python, "ties", "index"), "ties='index'");
  EXPECT_EQ(setting_with_number(Audience::command_line, "offset", 0.031), "--offset 0.031");
  EXPECT_EQ(setting_with_number(Audience::python, "offset", 0.031), "offset=0.031");
  EXPECT_EQ(setting_on(Audience::command_line, "similarity"), "--similarity");
  EXPECT_EQ(setting_on(Audience::python, "similarity"), "similarity=True");
}

}  // namespace

}  // namespace shapegauge
