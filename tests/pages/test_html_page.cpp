// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/pages/html_page.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Base64, MatchesTheExamplesOfRfc4648) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, PadsALongTextOnlyAtItsEnd) {
  const std::string text = base64(std::string(7 << 20, '\0'));
  EXPECT_EQ(text.size(), 4U * (((7 << 20) + 2) / 3));
  EXPECT_EQ(text.find('='), text.size() - 2);
}

TEST(RoundToDigits, RoundsToTheGivenNumberOfLeadingDigits) {
  EXPECT_EQ(rounded_to_digits(0.123456789, 3), 0.123);
  EXPECT_EQ(rounded_to_digits(98765.4321, 3), 98800);
  EXPECT_TRUE(std::isinf(rounded_to_digits(std::numeric_limits<double>::infinity(), 3)));
}

TEST(HtmlText, EscapesMarkup) { EXPECT_EQ(html_text("<a href=\"x\">&amp;"), "&lt;a href=&quot;x&quot;&gt;&amp;amp;"); }

TEST(ScriptData, EscapesScriptEndTagsInJson) {
  const nlohmann::ordered_json json{{"</script><!--", "a < b"}};
  const std::string text = script_data(json);
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_EQ(nlohmann::ordered_json::parse(text), json);
  EXPECT_EQ(nlohmann::ordered_json::parse(script_data({{"bytes", "\xff"}}))["bytes"], R"(\xFF)");
}

TEST(PageTemplate, DoesNotFillPlaceholdersInInsertedText) {
  const std::array<std::pair<std::string_view, std::string_view>, 2> marks{{{"{{a}}", "[{{b}}]"}, {"{{b}}", "{{a}}"}}};
  EXPECT_EQ(fill_placeholders("x{{a}}y{{b}}z", marks), "x[{{b}}]y{{a}}z");
}

TEST(PageFiles, ContainTheCopyrightNoticesOfLibraries) {
  EXPECT_THAT(std::string(page_files::chart_library()), HasSubstr("Copyright 2010-2020 Mike Bostock"));
  EXPECT_THAT(std::string(page_files::shape_library()), HasSubstr("Copyright 2010-2017 three.js authors"));
  for (const std::string_view library : {page_files::chart_library(), page_files::shape_library()}) {
    EXPECT_THAT(std::string(library), Not(HasSubstr("</script")));
    EXPECT_THAT(std::string(library), Not(HasSubstr("/usr/share")));
  }
}

}  // namespace

}  // namespace shapegauge
