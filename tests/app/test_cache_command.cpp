// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "shapegauge/experiments/cache/cache.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {

namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using CacheCommand = CommandTest;

TEST_F(CacheCommand, PrintsTheFolderAndContents) {
  Cache(at("cache")).put(EntryKind::field, std::string(64, '1'), std::string(1'500'000, 'x'));
  const Outcome outcome = succeeded(run("cache info --cache @cache"));
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("Cache in " + at("cache").string() + "\n"));
  EXPECT_THAT(outcome.output, ContainsRegex("\nfield +1 +1\\.5 MB\n"));
  EXPECT_THAT(outcome.output, ContainsRegex("\nall +1 +1\\.5 MB\n"));
}

TEST_F(CacheCommand, ClearRemovesTheCacheFolderAndPrintsTheNumberOfEntries) {
  Cache(at("cache")).put(EntryKind::field, std::string(64, '1'), 1);
  EXPECT_THAT(run("cache clear --cache @cache").output, ContainsRegex("1 entry, [0-9.]+ kB, removed"));
  EXPECT_FALSE(std::filesystem::exists(at("cache")));
  const Outcome again = succeeded(run("cache clear --cache @cache"));
  EXPECT_THAT(again.output, HasSubstr("0 entries"));
}

TEST_F(CacheCommand, RejectsUnknownCommandsAndAFileInPlaceOfTheCacheFolder) {
  test::write_text(at("file"), "x");
  expect_error_lines({{"cache empty", "there is no command \"empty\""},
                      {"cache info --cache " + quoted("file"), "cannot read the cache"},
                      {"cache clear --cache " + quoted("file"), "cannot read the cache"}});
}

}  // namespace

}  // namespace shapegauge::test_command_line
