// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/pages/search_page.h"
#include "tests/pages/sample_views.h"
#include "tests/support/page_text.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SearchPage, ContainsEachShapeOnceAndAllResults) {
  const SearchPage page = test_view::sample_search();
  const nlohmann::ordered_json data = test::json_of_page(search_page(page));
  ASSERT_EQ(data["shapes"].size(), 5U);
  EXPECT_EQ(data["shapes"][0]["name"], "query </script>.off");
  EXPECT_EQ(data["shapes"][1]["vertices"], shape_view_json(*page.shapes[1].view)["vertices"]);
  EXPECT_TRUE(data["shapes"][1].contains("picture"));
  EXPECT_FALSE(data["shapes"][3].contains("vertices"));
  EXPECT_EQ(data["answers"][0]["nearest"], (nlohmann::ordered_json{{1, 0.25}, {2, 0.5}, {3, 0.75}}));
  EXPECT_EQ(data["answers"][1]["failure"], "line 3: <nothing>");
  EXPECT_EQ(data["facts"][0], "2 queries");
}

TEST(SearchPage, EscapesMarkupInNames) {
  const std::string page = search_page(test_view::sample_search());
  EXPECT_THAT(page, HasSubstr("<title>&lt;b&gt;title&lt;/b&gt; {{script}}"));
  EXPECT_THAT(page, Not(HasSubstr("query </script>")));
  EXPECT_THAT(page, Not(HasSubstr("<nothing>")));
}

}  // namespace
}  // namespace shapegauge
