// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/leaderboard/leaderboard_tables.h"
#include "shapegauge/experiments/leaderboard/write_leaderboard.h"
#include "tests/experiments/leaderboard/small_board.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

class WriteLeaderboardSite : public testing::Test {
 protected:
  SiteUpdate update(const fs::path& folder) const {
    return write_site(folder, "Title", small.judged(), small.options());
  }
  void rename_class(const std::string& name) const {
    std::string labels = test_board::small_labels();
    for (std::size_t at = labels.find(",b\n"); at != std::string::npos; at = labels.find(",b\n")) {
      labels.replace(at, 3, "," + name + "\n");
    }
    test::write_text(small.labels(), labels);
  }

  const test_board::SmallBoard small;
  const fs::path site = small.folder.path() / "site";
};

TEST_F(WriteLeaderboardSite, WritesTheMainPageTheTablesAndAPagePerMethod) {
  const SiteUpdate first = update(site);
  EXPECT_EQ(first.written, 2U);
  for (const char* name : {"index.html", "leaderboard.csv", "leaderboard.tex", "leaderboard.json", "methods/good.html",
                           "methods/poor.html"}) {
    EXPECT_TRUE(fs::exists(site / name)) << name;
  }
  EXPECT_THAT(test::text_of(site / "index.html"), HasSubstr("methods/good.html"));
  EXPECT_THAT(test::text_of(site / "methods/good.html"), HasSubstr("shapegauge report"));
}

TEST_F(WriteLeaderboardSite, WritesOnlyPagesOfSubmissionsThatChanged) {
  update(site);
  test::write_text(site / "methods/good.html", "as it was");
  small.add("third.csv", test_board::small_matrix(1));
  const SiteUpdate second = update(site);
  EXPECT_EQ(second.written, 1U);
  EXPECT_EQ(second.unchanged, 2U);
  EXPECT_EQ(test::text_of(site / "methods/good.html"), "as it was");

  fs::remove(small.submissions() / "poor.csv");
  small.add("good.csv", test_board::small_matrix(0.1));
  const SiteUpdate third = update(site);
  EXPECT_EQ(third.written, 1U);
  EXPECT_EQ(third.removed, 1U);
  EXPECT_FALSE(fs::exists(site / "methods/poor.html"));
  EXPECT_NE(test::text_of(site / "methods/good.html"), "as it was");
}

TEST_F(WriteLeaderboardSite, RewritesPagesWhenClassesAreRenamed) {
  update(site);
  rename_class("renamed");
  EXPECT_EQ(update(site).written, 2U);
  EXPECT_THAT(test::text_of(site / "methods/good.html"), HasSubstr("renamed"));
}

TEST_F(WriteLeaderboardSite, CompletesASiteAfterAnInterruption) {
  // A page that cannot be written: a folder has its name.
  fs::create_directories(site / "methods" / "good.html" / "in the way");
  EXPECT_ANY_THROW(check_site_folder(site)) << "no site yet";
  fs::rename(site / "methods", small.folder.path() / "aside");
  test::write_text(site / ".shapegauge-lock", "");
  update(site);

  const std::string whole = test::text_of(site / "methods/good.html");
  small.add("good.csv", test_board::small_matrix(0.1));
  fs::remove(site / "methods/good.html");
  fs::rename(small.folder.path() / "aside" / "good.html", site / "methods" / "good.html");
  EXPECT_ANY_THROW(update(site));
  fs::remove_all(site / "methods" / "good.html");
  test::write_text(site / "methods/good.html", "half");
  update(site);
  EXPECT_THAT(test::text_of(site / "methods/good.html"), HasSubstr("shapegauge report"));

  // The earlier submission again: its page is not mistaken for the one written before the interruption.
  small.add("good.csv", test_board::small_matrix(0));
  update(site);
  EXPECT_EQ(test::text_of(site / "methods/good.html"), whole);
}

TEST_F(WriteLeaderboardSite, WritesNoFolderPathsIntoPages) {
  small.add("broken.npy", "no numbers");
  small.add("few.lists", "m0 m3 m6\n");
  update(site);
  for (const char* name : {"index.html", "leaderboard.json", "leaderboard.csv", "methods/good.html"}) {
    EXPECT_THAT(test::text_of(site / name), testing::Not(HasSubstr(small.folder.path().string()))) << name;
  }
  const fs::path elsewhere = "/a/b/m.npy";
  EXPECT_EQ(without_folders("/a/b/m.npy: row 3 of /a/labels.csv", elsewhere, {.matrix = {}, .labels = "/a/labels.csv"}),
            "m.npy: row 3 of labels.csv");
}

TEST_F(WriteLeaderboardSite, HidesClassNamesAndScoresOnRequest) {
  update(site);
  JudgingOptions options = small.options();
  rename_class("secret");
  options.hide_classes = true;
  EXPECT_EQ(write_site(site, "Title", small.judged(), options).removed, 2U);
  EXPECT_TRUE(fs::is_empty(site / "methods"));
  for (const char* name : {"index.html", "leaderboard.json", "leaderboard.csv"}) {
    EXPECT_THAT(test::text_of(site / name), testing::Not(HasSubstr("secret"))) << name;
  }
  EXPECT_THAT(test::text_of(site / "index.html"), HasSubstr("\"per_class\":[]"));
}

TEST_F(WriteLeaderboardSite, UpdatedSiteHasTheContentsOfAFreshSite) {
  update(small.folder.path() / "grown");
  small.add("third.csv", test_board::small_matrix(1));
  update(small.folder.path() / "grown");
  update(small.folder.path() / "fresh");
  for (const char* name : {"index.html", "leaderboard.json", "methods/third.html", "methods/good.html"}) {
    EXPECT_EQ(test::text_of(small.folder.path() / "grown" / name), test::text_of(small.folder.path() / "fresh" / name))
        << name;
  }
}

TEST_F(WriteLeaderboardSite, RanksSubmittedRankedListsButWritesNoPageForThem) {
  small.add("lists.lists", "m0 m3 m6\nm1 m4\n");
  const SiteUpdate written = update(site);
  EXPECT_EQ(written.written, 2U);
  EXPECT_THAT(test::text_of(site / "leaderboard.csv"), HasSubstr("lists.lists"));
  EXPECT_FALSE(fs::exists(site / "methods/lists.html"));
}

TEST_F(WriteLeaderboardSite, RejectsFoldersWithUnrelatedFiles) {
  test::write_text(site / "thesis.txt", "mine");
  EXPECT_THAT(test::input_error_of([&] { update(site); }), HasSubstr(site.string()));
  test::write_text(site / "leaderboard.json", "{}");
  EXPECT_THAT(test::input_error_of([&] { update(site); }), HasSubstr(site.string()));
  EXPECT_FALSE(fs::exists(site / "index.html"));
  EXPECT_THAT(test::input_error_of([&] { update(small.labels()); }), HasSubstr("file"));
}

TEST_F(WriteLeaderboardSite, RemovesNoFilesOutsideItsFolder) {
  update(site);
  auto json = nlohmann::ordered_json::parse(test::text_of(site / "leaderboard.json"));
  test::write_text(small.folder.path() / "victim.html", "stays");
  test::write_text(site / "other.html", "stays");
  json["pages"]["methods/../../victim.html"] = "x";
  json["pages"]["../victim.html"] = "x";
  json["pages"]["other.html"] = "x";
  test::write_text(site / "leaderboard.json", json.dump());
  EXPECT_EQ(update(site).removed, 0U);
  EXPECT_TRUE(fs::exists(small.folder.path() / "victim.html"));
  EXPECT_TRUE(fs::exists(site / "other.html"));
}

}  // namespace

}  // namespace shapegauge
