// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/segmentation_page.h"
#include "tests/pages/sample_segmentation.h"
#include "tests/support/page_text.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SegmentationPage, EscapesMarkupInNames) {
  const std::string html = segmentation_page(test_segmentation::sample_page());
  EXPECT_THAT(html, HasSubstr("<h1>&lt;b&gt;title&lt;/b&gt; {{data}}</h1>"));
  for (const char* word : {"<b>title", "line 3: <nothing>", " href=\"http", "@import"}) {
    EXPECT_THAT(html, Not(HasSubstr(word)));
  }
}

TEST(SegmentationPage, ContainsPicturesViewsAndErrorsPerClass) {
  const SegmentationPage page = test_segmentation::sample_page();
  const auto data = test::json_of_page(segmentation_page(page));
  EXPECT_EQ(data["errors"]["methods"], page.errors->methods);
  EXPECT_TRUE(data["errors"]["by_class"][1][1].is_null());
  EXPECT_EQ(data["errors"]["by_class"][1][0], 0.4);
  EXPECT_EQ(data["errors"]["tables"][0]["rows"], page.errors->tables[0].rows);
  EXPECT_EQ(data["shown"][0]["pictures"][1]["png"], base64(page.shown[0].pictures[1].png));
  EXPECT_EQ(data["shown"][0]["view"]["parts"].size(), 2U);
  EXPECT_TRUE(data["shown"][1]["view"].is_null());
  EXPECT_EQ(data["typical"], (nlohmann::ordered_json{1}));
}

TEST(SegmentationPage, OmitsErrorsWithoutReferenceSegmentations) {
  SegmentationPage page = test_segmentation::sample_page();
  page.errors.reset();
  EXPECT_TRUE(test::json_of_page(segmentation_page(page))["errors"].is_null());
}

}  // namespace
}  // namespace shapegauge
