// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "shapegauge/pages/report.h"
#include "tests/pages/sample_reports.h"
#include "tests/support/page_text.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ReportPage, EscapesMarkupInNames) {
  const std::string page = report_page(test_report::hostile_report().report);
  EXPECT_EQ(test::occurrences(page, "</script>"), 3U) << "the library, the data, the scripts";
  EXPECT_EQ(test::occurrences(page, "</title>"), 1U);
  EXPECT_THAT(page, HasSubstr("<title>&lt;/title&gt;&lt;/script&gt;"));
  const auto data = test::json_of_page(page);
  const Report& report = test_report::hostile_report().report;
  EXPECT_EQ(data["title"], report.title);
  EXPECT_EQ(data["description"], report.description);
  EXPECT_EQ(data["classes"], report.classes);
  EXPECT_EQ(data["ids"][0], report.ids[0]);
  EXPECT_EQ(data["ids"][3], R"(bytes that are no text: \xFF\xFE)");
  EXPECT_EQ(data["methods"][1]["name"], report.methods[1].name);
}

TEST(ReportPage, LoadsNoExternalResources) {
  const std::string page = report_page(test_report::plain_report().report);
  for (const char* word : {" src=\"", " href=\"http", "@import", "url("}) EXPECT_THAT(page, Not(HasSubstr(word)));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

}  // namespace

}  // namespace shapegauge
