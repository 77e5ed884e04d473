#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include "shapegauge/pages/leaderboard_page.h"
#include "tests/pages/sample_leaderboard.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

nlohmann::ordered_json board_in(const std::string& page) {
  const std::string opening = R"(id="page-data">)";
  const std::size_t begin = page.find(opening) + opening.size();
  return nlohmann::ordered_json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(LeaderboardPage, NoNameCanBreakThePage) {
  const std::string page = leaderboard_page(test_leaderboard::sample_leaderboard().page);
  EXPECT_EQ(occurrences(page, "</script>"), 3U) << "the library, the data, the scripts";
  EXPECT_EQ(occurrences(page, "</title>"), 1U);
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
}

TEST(LeaderboardPage, HasTheStandingsOfEveryMethodAndMeasure) {
  const LeaderboardPage& sample = test_leaderboard::sample_leaderboard().page;
  const auto board = board_in(leaderboard_page(sample));
  ASSERT_EQ(board["methods"].size(), sample.entries.size());
  ASSERT_EQ(board["micro"].size(), sample.micro.size());
  const MethodStanding& third = sample.macro[2][3];
  EXPECT_EQ(board["macro"][2][3]["rank"], third.rank);
  EXPECT_EQ(board["macro"][2][3]["letters"], third.letters);
  EXPECT_NEAR(board["macro"][2][3]["interval"][1].get<double>(), third.interval->high, 1e-5);
  EXPECT_EQ(board["downloads"]["csv"], sample.csv);
  EXPECT_EQ(board["refused"][0][1], "row 3 </script> is NaN");
  EXPECT_EQ(board["methods"][0]["url"], sample.entries[0].url);
  EXPECT_EQ(board["methods"][1]["evaluations"][0]["per_class"].size(), 4U);
}

TEST(LeaderboardPage, TheSameBytesForAnyNumberOfThreads) {
  const LeaderboardPage& sample = test_leaderboard::sample_leaderboard().page;
  const std::string page = leaderboard_page(sample);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(leaderboard_page(sample), page);
}

}  // namespace

}  // namespace shapegauge
