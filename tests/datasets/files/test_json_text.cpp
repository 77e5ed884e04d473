// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/datasets/files/json_text.h"

namespace shapegauge {

namespace {

TEST(JsonText, EscapesBytesThatAreNotUtf8) {
  const nlohmann::ordered_json json{{"V\xf6gel", {"a\xff", 1.5, nullptr}}, {"b", {{"\xe4", true}}}};
  const nlohmann::ordered_json expected{{"V\\xF6gel", {"a\\xFF", 1.5, nullptr}}, {"b", {{"\\xE4", true}}}};
  EXPECT_EQ(json_text(json), expected.dump());
  EXPECT_EQ(json_text(json, 2), expected.dump(2));
  EXPECT_EQ(escaped_json(json), expected);
}

TEST(JsonText, LeavesValidUtf8Unchanged) {
  const nlohmann::json json{{"St\u00e4hl", {"\u4e2d", "a\\b\n"}}, {"empty", nlohmann::json::array()}};
  EXPECT_EQ(json_text(json), json.dump());
  EXPECT_EQ(escaped_json(json), json);
}

TEST(JsonText, EscapesDifferentInvalidBytesToDifferentText) {
  EXPECT_NE(json_text(nlohmann::json("\xe4")), json_text(nlohmann::json("\xf6")));
}

}  // namespace

}  // namespace shapegauge
