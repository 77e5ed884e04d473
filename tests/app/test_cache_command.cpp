// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "shapegauge/experiments/cache/cache.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test_command_line::expect_error_lines;
using test_command_line::Outcome;
using test_command_line::run_executable;
using testing::ContainsRegex;
using testing::HasSubstr;

TEST(CacheCommand, SaysWhereTheCacheIsAndWhatItHolds) {
  const test::TemporaryFolder folder;
  const std::string cache = (folder.path() / "cache").string();
  Cache(cache).put(EntryKind::field, std::string(64, '1'), std::string(1'500'000, 'x'));
  const Outcome outcome = run_executable("cache info --cache '" + cache + "'");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("Cache in " + cache + "\n"));
  EXPECT_THAT(outcome.output, ContainsRegex("\nfield +1 +1\\.5 MB\n"));
  EXPECT_THAT(outcome.output, ContainsRegex("\nall +1 +1\\.5 MB\n"));
}

TEST(CacheCommand, ClearsItAndAnEmptyOneToo) {
  const test::TemporaryFolder folder;
  const std::string cache = (folder.path() / "cache").string();
  Cache(cache).put(EntryKind::field, std::string(64, '1'), 1);
  EXPECT_THAT(run_executable("cache clear --cache '" + cache + "'").output,
              ContainsRegex("1 entry, [0-9.]+ kB, removed"));
  EXPECT_FALSE(std::filesystem::exists(cache));
  const Outcome again = run_executable("cache clear --cache '" + cache + "'");
  EXPECT_EQ(again.status, 0);
  EXPECT_THAT(again.output, HasSubstr("0 entries"));
}

TEST(CacheCommand, UnusableArgumentsAreOneClearLine) {
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / "file", "x");
  expect_error_lines({{"cache empty", "there is no command \"empty\""},
                      {"cache info --cache '" + (folder.path() / "file").string() + "'", "cannot read the cache"},
                      {"cache clear --cache '" + (folder.path() / "file").string() + "'", "cannot read the cache"}});
}

}  // namespace

}  // namespace shapegauge
