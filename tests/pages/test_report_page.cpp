#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include "shapegauge/pages/report.h"
#include "shapegauge/pages/report_json.h"
#include "tests/pages/sample_reports.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// The data as the page has it.
nlohmann::ordered_json data_in(const std::string& page) {
  const std::string opening = R"(id="page-data">)";
  const std::size_t begin = page.find(opening) + opening.size();
  return nlohmann::ordered_json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(ReportPage, NoNameCanBreakThePage) {
  const std::string page = report_page(test_report::hostile_report().report);
  EXPECT_EQ(count(page, "</script>"), 3U) << "the library, the data, the scripts";
  EXPECT_EQ(count(page, "</title>"), 1U);
  EXPECT_THAT(page, HasSubstr("<title>&lt;/title&gt;&lt;/script&gt;"));
  const auto data = data_in(page);
  const Report& report = test_report::hostile_report().report;
  EXPECT_EQ(data["title"], report.title);
  EXPECT_EQ(data["description"], report.description);
  EXPECT_EQ(data["classes"], report.classes);
  EXPECT_EQ(data["ids"][0], report.ids[0]);
  EXPECT_EQ(data["ids"][3], R"(bytes that are no text: \xFF\xFE)");
  EXPECT_EQ(data["methods"][1]["name"], report.methods[1].name);
}

TEST(ReportPage, AsksForNothingButItself) {
  const std::string page = report_page(test_report::plain_report().report);
  for (const char* word : {" src=\"", " href=\"http", "@import", "url("}) EXPECT_THAT(page, Not(HasSubstr(word)));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(ReportPage, NamesTheChartLibrarysLicence) {
  const std::string page = report_page(test_report::plain_report().report);
  EXPECT_THAT(page, HasSubstr("Copyright 2010-2020 Mike Bostock"));
  EXPECT_THAT(page, Not(HasSubstr("/usr/share")));
}

TEST(ReportPage, NoMarkIsLeftOpen) {
  const std::string page = report_page(test_report::plain_report().report);
  for (const char* mark : {"{{title}}", "{{style}}", "{{d3}}", "{{data}}", "{{script}}"})
    EXPECT_THAT(page, Not(HasSubstr(mark)));
}

TEST(ReportPage, TheSameBytesForAnyNumberOfThreads) {
  const Report& report = test_report::hostile_report().report;
  const std::string page = report_page(report);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(report_page(report), page);
}

}  // namespace

}  // namespace shapegauge
