// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/datasets/files/csv.h"
#include "tests/app/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {

namespace {

using testing::HasSubstr;
using testing::Not;

/// A folder of small shapes, models/, and a fast method, fast.json.
class SearchCommand : public CommandTest {
 protected:
  void SetUp() override {
    test::write_small_dataset(at("models"));
    test::write_text(at("fast.json"), R"({"name": "fast", "dataset": {"layout": "shrec11", "root": "${UNSET_ROOT}"},
      "signatures": [{"name": "d2", "descriptor": {"type": "d2"}},
                     {"name": "more", "descriptor": {"type": "d2", "bins": 30}}]})");
    write_off(at("query.off"), test::small_shape("box", 5));
  }
  /// With the fast method and the fixture's cache.
  [[nodiscard]] Outcome search(const std::string& arguments) const {
    return run_executable("search " + arguments + " --method " + quoted("fast.json") + " --cache " + quoted("cache"));
  }
  [[nodiscard]] Outcome search(const std::string& query, const std::string& options) const {
    return search(quoted(query) + " " + quoted("models") + " " + options);
  }
};

TEST_F(SearchCommand, ListsTheNearestShapesOfAQuery) {
  const Outcome outcome = succeeded(search("query.off", "-k 3"));
  EXPECT_THAT(outcome.output, HasSubstr("rank"));
  for (const char* box : {"T1.off", "T4.off", "T7.off"}) EXPECT_THAT(outcome.output, HasSubstr(box));
  EXPECT_THAT(outcome.errors, HasSubstr("9 of 9 shapes indexed"));
  const Outcome again = search("query.off", "-k 3");
  EXPECT_EQ(again.output, outcome.output);
  EXPECT_EQ(again.errors, "");
  EXPECT_TRUE(std::filesystem::exists(at("models.fast.search-index")));
}

TEST_F(SearchCommand, CountsSkippedFilesOfTheCollection) {
  const std::size_t others = 1;  // test.cla
  test::write_text(at("models/readme.txt"), "hello");
  test::write_text(at("models/.hidden"), "hello");
  EXPECT_THAT(search("query.off", "").errors,
              HasSubstr("skipped: " + std::to_string(others + 1) + " files that are not shapes"));
  EXPECT_THAT(search("query.off", "").errors, Not(HasSubstr("skipped")));
}

TEST_F(SearchCommand, PrintsTheSameResultsInJsonAndCsv) {
  const nlohmann::json json = nlohmann::json::parse(search("models/T4.off", "-k 4 --format json").output);
  EXPECT_EQ(json["models"], 9);
  EXPECT_EQ(json["signature"], "more");
  EXPECT_EQ(json["queries"][0]["name"], "T4.off");
  const auto& results = json["queries"][0]["results"];
  ASSERT_EQ(results.size(), 4U);
  EXPECT_EQ(results[0]["file"], (at("models") / results[0]["name"].get<std::string>()).string());
  const std::vector<CsvRow> rows = parse_csv(search("models/T4.off", "-k 4 --format csv").output, "answer");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].cells, (std::vector<std::string>{"query", "name", "rank", "distance"}));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(rows[i + 1].cells[1], results[i]["name"].get<std::string>());
    EXPECT_EQ(rows[i + 1].cells[2], std::to_string(i + 1));
    EXPECT_EQ(std::stod(rows[i + 1].cells[3]), results[i]["distance"].get<double>());
    EXPECT_NE(rows[i + 1].cells[1], "T4.off");
  }
}

TEST_F(SearchCommand, DistancesFollowTheRequestedSignatureAndSettings) {
  const auto distance = [&](const std::string& options) {
    const auto json = nlohmann::json::parse(search("query.off", options + " -k 1 --format json").output);
    return json["queries"][0]["results"][0]["distance"].get<double>();
  };
  const double of_last = distance("");
  EXPECT_NE(distance("--signature d2"), of_last);
  EXPECT_EQ(distance("--signature d2 --set signatures.0.descriptor.bins=30"), of_last);
}

TEST_F(SearchCommand, NamesUnusableQueriesAndAnswersOtherQueries) {
  test::write_text(at("models/T7.off"), "OFF\n1 0 0\n0 0\n");
  test::write_text(at("broken.off"), "OFF\n");
  const Outcome outcome = search(quoted("broken.off") + " " + quoted("query.off") + " " + quoted("models"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("warning: omitted T7.off"));
  EXPECT_THAT(outcome.errors, HasSubstr("broken.off"));
  EXPECT_THAT(outcome.output, HasSubstr("query.off"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("T7.off")));
  const Outcome later = succeeded(search("query.off", ""));
  EXPECT_THAT(later.errors, HasSubstr("1 of 9 shapes"));
  EXPECT_EQ(search("broken.off", "").status, 2);
}

TEST_F(SearchCommand, IndexIsWrittenWithoutQueriesAndKeptByNoUpdateOption) {
  const Outcome described = succeeded(search(quoted("models") + " --index " + quoted("own.index")));
  EXPECT_EQ(described.output, "");
  ASSERT_TRUE(std::filesystem::exists(at("own.index")));
  std::filesystem::remove(at("models/T0.off"));
  const Outcome stale = succeeded(search("query.off", "--no-update --index " + quoted("own.index")));
  EXPECT_THAT(stale.output, HasSubstr("T0.off"));
  EXPECT_THAT(search("query.off", "--index " + quoted("own.index")).output, Not(HasSubstr("T0.off")));
  expect_error_line(search("query.off", "--no-update --index " + quoted("absent.index")), "absent.index");
}

TEST_F(SearchCommand, WritesAnHtmlPageOfTheResults) {
  test::write_text(at("broken.off"), "OFF\n");
  const std::string queries = quoted("broken.off") + " " + quoted("query.off") + " " + quoted("models");
  EXPECT_EQ(search(queries + " -k 2 -o " + quoted("one.html")).status, 1);
  const std::string page = test::bytes_of(at("one.html"));
  EXPECT_THAT(page, HasSubstr("2 queries in "));
  EXPECT_THAT(page, HasSubstr("Thickness"));
  EXPECT_EQ(search(queries + " -k 2 --replace --up -x -o " + quoted("one.html")).status, 1);
  EXPECT_NE(test::bytes_of(at("one.html")), page);
  expect_error_line(search("query.off", "-o " + quoted("one.html")), "one.html exists");
  expect_error_line(search("query.off", "-o " + quoted("page.txt")), "page.txt");
  expect_error_line(search(quoted("models") + " -o " + quoted("new.html")), "--output requires queries");
}

TEST_F(SearchCommand, RejectsMissingCollectionsInvalidIndexesAndUnknownSignatures) {
  expect_error_line(run_executable("search"), "paths is required");
  expect_error_line(run("search @query.off"), "is not a collection");
  expect_error_line(run("search @absent"), "No such file or directory");
  expect_error_line(search("query.off", "-k 0"), "--count");
  expect_error_line(search("query.off", "--signature d3"), "did you mean");
  expect_error_line(search("query.off", "--index " + quoted("query.off")), "--index");
  expect_error_line(search("query.off", "--index " + quoted("models/T1.off")), "is not an index");
  expect_error_line(search("query.off", "-o " + quoted("o.html") + " --index " + quoted("o.html")),
                    "--index and --output would both be written to");
  expect_error_line(run("search @query.off @models --signature d2"), "require --configuration");
  expect_error_line(search("query.off", "--articulated"), "--articulated");
}

TEST_F(SearchCommand, ArticulatedOptionFindsSimilarShapesAndWritesItsOwnIndex) {
  const Outcome outcome = succeeded(run("search @query.off @models -k 3 --articulated --cache @cache"));
  for (const char* box : {"T1.off", "T4.off", "T7.off"}) EXPECT_THAT(outcome.output, HasSubstr(box));
  EXPECT_TRUE(std::filesystem::exists(at("models.recommended_articulated.search-index")));
}

TEST_F(SearchCommand, RerankOptionReranksTheResultsOfTheDefaultMethod) {
  const Outcome outcome = succeeded(run("search @query.off @models -k 3 --rerank --format json --cache @cache"));
  const nlohmann::json json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["reranked"], true);
  EXPECT_EQ(json["queries"][0]["results"].size(), 3U);
  EXPECT_TRUE(std::filesystem::exists(at("models.search-index")));
}

}  // namespace

}  // namespace shapegauge::test_command_line
