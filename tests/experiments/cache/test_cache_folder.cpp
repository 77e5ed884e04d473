// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cstdlib>
#include <gmock/gmock.h>
#include <optional>
#include <string>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;

/// Sets or clears an environment variable during its lifetime.
class Variable {
 public:
  Variable(const char* name, const std::optional<std::string>& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  Variable(Variable&&) = delete;
  Variable& operator=(Variable&&) = delete;
  ~Variable() { set(before_); }

 private:
  void set(const std::optional<std::string>& value) const {
    if (value) {
      ::setenv(name_, value->c_str(), 1);
    } else {
      ::unsetenv(name_);
    }
  }

  const char* name_;
  std::optional<std::string> before_;
};

TEST(CacheFolder, DefaultFollowsEnvironmentVariablesAndTheXdgSpecification) {
  const Variable home("HOME", "/home/someone");
  const Variable xdg("XDG_CACHE_HOME", std::nullopt);
  const Variable named("SHAPEGAUGE_CACHE", std::nullopt);
  EXPECT_EQ(default_cache_folder(), "/home/someone/.cache/shapegauge");
  {
    const Variable elsewhere("XDG_CACHE_HOME", "/var/caches");
    EXPECT_EQ(default_cache_folder(), "/var/caches/shapegauge");
    const Variable here("SHAPEGAUGE_CACHE", "here");
    EXPECT_EQ(default_cache_folder(), "here");
    const Variable none("SHAPEGAUGE_CACHE", "");
    EXPECT_EQ(default_cache_folder(), "");
  }
  const Variable relative("XDG_CACHE_HOME", "caches");
  EXPECT_EQ(default_cache_folder(), "/home/someone/.cache/shapegauge") << "a relative one does not count";
  const Variable homeless("HOME", std::nullopt);
  EXPECT_EQ(default_cache_folder(), "");
}

TEST(CacheFolder, SizeLimitAcceptsUnitSuffixes) {
  EXPECT_EQ(parse_size("0", "x"), 0U);
  EXPECT_EQ(parse_size("123", "x"), 123U);
  EXPECT_EQ(parse_size("5K", "x"), 5000U);
  EXPECT_EQ(parse_size("20M", "x"), 20'000'000U);
  EXPECT_EQ(parse_size("3G", "x"), 3'000'000'000U);
  EXPECT_EQ(parse_size("2T", "x"), 2'000'000'000'000U);
  for (const char* wrong :
       {"", "G", "-1", "1.5G", "10 G", "10GB", "10g", "18446744073709551615K", "99999999999999999999"}) {
    EXPECT_THAT(test::input_error_of([&] { parse_size(wrong, "LIMIT"); }), HasSubstr("LIMIT must be a size")) << wrong;
  }
}

TEST(CacheFolder, SizeLimitIsReadFromAnEnvironmentVariable) {
  const Variable unset("SHAPEGAUGE_CACHE_LIMIT", std::nullopt);
  EXPECT_EQ(cache_limit(), 10'000'000'000U);
  const Variable set("SHAPEGAUGE_CACHE_LIMIT", "1M");
  EXPECT_EQ(cache_limit(), 1'000'000U);
}

namespace fs = std::filesystem;
using test::write_text;

class CacheContentsTest : public test::FolderTest {
 protected:
  [[nodiscard]] fs::path folder() const { return at("cache"); }
  /// Stores a value, last used the given number of hours ago.
  void keep(EntryKind kind, char digit, std::size_t size, int hours = 0) const {
    const std::string key(64, digit);
    Cache(folder()).put(kind, key, std::string(size, 'x'));
    fs::last_write_time(entry_path(folder(), kind, key), fs::file_time_type::clock::now() - std::chrono::hours(hours));
  }
};

TEST_F(CacheContentsTest, CountsEntriesByKind) {
  keep(EntryKind::field, '1', 1000);
  keep(EntryKind::field, '2', 1000);
  keep(EntryKind::distances, '1', 10);
  const CacheContents contents = cache_contents(folder());
  const auto& fields = contents.by_kind.at(static_cast<std::size_t>(EntryKind::field));
  EXPECT_EQ(fields.entries, 2U);
  EXPECT_GT(fields.bytes, 2000U);
  EXPECT_LT(fields.bytes, 2500U);
  EXPECT_EQ(contents.total().entries, 3U);
  EXPECT_EQ(cache_contents(folder() / "absent").total().entries, 0U);
}

TEST_F(CacheContentsTest, ClearingTheCacheRemovesTheFolder) {
  keep(EntryKind::shape, '1', 10);
  EXPECT_TRUE(fs::exists(folder() / "CACHEDIR.TAG"));
  EXPECT_EQ(clear_cache(folder()).total().entries, 1U);
  EXPECT_FALSE(fs::exists(folder()));
  EXPECT_EQ(clear_cache(folder()).total().entries, 0U);
}

TEST_F(CacheContentsTest, ClearingTheCacheKeepsFilesThatAreNotEntries) {
  keep(EntryKind::shape, '1', 10);
  const std::string digits(62, '1');
  const std::vector<std::string> others{"notes.txt",
                                        "11/notes.txt",
                                        "11/" + digits + ".off",
                                        "aa/" + digits,
                                        "abc/" + digits + ".shape",
                                        "11/x" + digits + ".shape",
                                        "11/" + digits + ".shape.bak"};
  for (const std::string& other : others) write_text(folder() / other, "mine");
  EXPECT_EQ(clear_cache(folder()).total().entries, 1U);
  for (const std::string& other : others) EXPECT_TRUE(fs::exists(folder() / other)) << other;
}

TEST_F(CacheContentsTest, TrimmingTheCacheRemovesLeastRecentlyUsedEntries) {
  keep(EntryKind::field, '1', 1000, 30);
  keep(EntryKind::field, '2', 1000, 10);
  keep(EntryKind::field, '3', 1000, 20);
  trim_cache(folder(), 10'000);
  EXPECT_EQ(cache_contents(folder()).total().entries, 3U);
  // The first is the oldest, but has just been used.
  EXPECT_TRUE(Cache(folder()).find<std::string>(EntryKind::field, std::string(64, '1')));
  trim_cache(folder(), 2500);
  EXPECT_TRUE(fs::exists(entry_path(folder(), EntryKind::field, std::string(64, '1'))));
  EXPECT_TRUE(fs::exists(entry_path(folder(), EntryKind::field, std::string(64, '2'))));
  EXPECT_FALSE(fs::exists(entry_path(folder(), EntryKind::field, std::string(64, '3'))));
}

TEST_F(CacheContentsTest, RemovesOldTemporaryFilesOfKilledRuns) {
  const fs::path left = folder() / "11" / (std::string(62, '1') + ".field.123-4.part");
  write_text(left, "half");
  EXPECT_EQ(cache_contents(folder()).unfinished.entries, 1U);
  trim_cache(folder(), 10'000);
  EXPECT_TRUE(fs::exists(left)) << "another run may be writing it";
  fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(2));
  trim_cache(folder(), 10'000);
  EXPECT_FALSE(fs::exists(left));
}

TEST_F(CacheContentsTest, RejectsAFileInPlaceOfTheCacheFolder) {
  write_text(folder(), "a file");
  EXPECT_THAT(test::input_error_of([&] { cache_contents(folder()); }), HasSubstr("cannot read the cache"));
}

}  // namespace

}  // namespace shapegauge
