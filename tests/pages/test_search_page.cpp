#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/pages/search_page.h"
#include "tests/pages/sample_views.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The data that the page's script reads.
nlohmann::json data_of_search(const std::string& page) {
  const std::string begin = R"(id="page-data">)";
  const std::size_t from = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(SearchPage, HasEachShapeOnceAndTheAnswers) {
  const SearchPage page = test_view::sample_search();
  const nlohmann::json data = data_of_search(search_page(page));
  ASSERT_EQ(data["shapes"].size(), 5U);
  EXPECT_EQ(data["shapes"][0]["name"], "query </script>.off");
  EXPECT_EQ(data["shapes"][1]["vertices"], nlohmann::json(shape_view_json(*page.shapes[1].view))["vertices"]);
  EXPECT_TRUE(data["shapes"][1].contains("picture"));
  EXPECT_FALSE(data["shapes"][3].contains("vertices"));
  EXPECT_EQ(data["answers"][0]["nearest"], (nlohmann::json{{1, 0.25}, {2, 0.5}, {3, 0.75}}));
  EXPECT_EQ(data["answers"][1]["failure"], "line 3: <nothing>");
  EXPECT_EQ(data["facts"][0], "2 queries");
}

TEST(SearchPage, NamesAreTextAndNoMarkup) {
  const std::string page = search_page(test_view::sample_search());
  EXPECT_THAT(page, HasSubstr("<title>&lt;b&gt;title&lt;/b&gt; {{script}}"));
  EXPECT_THAT(page, Not(HasSubstr("query </script>")));
  EXPECT_THAT(page, Not(HasSubstr("<nothing>")));
}

}  // namespace
}  // namespace shapegauge
