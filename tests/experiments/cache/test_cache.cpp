// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <chrono>
#include <csignal>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <optional>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <vector>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

const std::string key(64, 'a');
const std::string content("values\0\n\xff and more", 18);

TEST(CacheEntry, RestoresItsContentWhenDecoded) {
  for (const std::string& one : {content, std::string(), std::string(5000, '\n')}) {
    EXPECT_EQ(decode_entry(EntryKind::field, key, encode_entry(EntryKind::field, key, one)), one);
  }
}

TEST(CacheEntry, DetectsEveryFlippedBit) {
  const std::string bytes = encode_entry(EntryKind::picture, key, content);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(static_cast<unsigned char>(damaged[i]) ^ (1U << bit));
      EXPECT_EQ(decode_entry(EntryKind::picture, key, damaged), std::nullopt) << "byte " << i << " bit " << bit;
    }
  }
}

TEST(CacheEntry, DetectsTruncationsAndAdditions) {
  const std::string bytes = encode_entry(EntryKind::shape, key, content);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_EQ(decode_entry(EntryKind::shape, key, bytes.substr(0, size)), std::nullopt) << size;
  }
  EXPECT_EQ(decode_entry(EntryKind::shape, key, bytes + '\0'), std::nullopt);
}

TEST(CacheEntry, IsRejectedUnderAnotherKindOrKey) {
  const std::string bytes = encode_entry(EntryKind::shape, key, content);
  EXPECT_EQ(decode_entry(EntryKind::field, key, bytes), std::nullopt);
  EXPECT_EQ(decode_entry(EntryKind::shape, std::string(64, 'b'), bytes), std::nullopt);
}

namespace fs = std::filesystem;
using test::text_of;
using test::write_text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string entry_key(64, '0');

class CacheTest : public test::FolderTest {
 protected:
  [[nodiscard]] fs::path folder() const { return at("cache"); }
  [[nodiscard]] fs::path entry() const { return entry_path(folder(), EntryKind::field, entry_key); }
  void keep(const std::string& value) const { Cache(folder()).put(EntryKind::field, entry_key, value); }
  static std::optional<std::string> found(Cache& cache) { return cache.find<std::string>(EntryKind::field, entry_key); }
  [[nodiscard]] std::optional<std::string> found() const {
    Cache cache(folder());
    return found(cache);
  }
};

TEST_F(CacheTest, StoredResultsAreFoundByKindAndKey) {
  keep("value");
  Cache cache(folder());
  EXPECT_EQ(found(cache), "value");
  EXPECT_EQ(cache.find<std::string>(EntryKind::shape, entry_key), std::nullopt);
  EXPECT_EQ(cache.find<std::string>(EntryKind::field, std::string(64, '1')), std::nullopt);
  EXPECT_THAT(cache.warnings(), IsEmpty());
}

TEST_F(CacheTest, ComputesEachResultOnce) {
  int computed = 0;
  const auto get = [&](Cache& cache) {
    return cache.get(EntryKind::field, entry_key, [&] { return ++computed * 1.5; });
  };
  for (int run = 0; run < 2; ++run) {
    Cache cache(folder());
    EXPECT_EQ(get(cache), 1.5);
    EXPECT_EQ(get(cache), 1.5);
    const CacheUse use = cache.report().uses.at(static_cast<std::size_t>(EntryKind::field));
    EXPECT_EQ(use.computed, run == 0 ? 1U : 0U);
    EXPECT_EQ(use.hits, run == 0 ? 1U : 2U);
  }
  EXPECT_EQ(computed, 1);
}

TEST_F(CacheTest, ComputesAResultOnceForConcurrentRequests) {
  Cache cache(folder());
  std::atomic<int> computed = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i) {
      threads.emplace_back([&] {
        const int value = cache.get(EntryKind::field, entry_key, [&] {
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
          return ++computed;
        });
        EXPECT_EQ(value, 1);
      });
    }
  }
  EXPECT_EQ(computed, 1);
}

TEST_F(CacheTest, DoesNotStoreErrors) {
  Cache cache(folder());
  const auto fail = [&](bool fails) {
    return cache.get(EntryKind::field, entry_key, [&] {
      if (fails) throw std::runtime_error("no");
      return 1;
    });
  };
  EXPECT_THROW(fail(true), std::runtime_error);
  EXPECT_THROW(fail(true), std::runtime_error);
  EXPECT_EQ(fail(false), 1);
}

TEST_F(CacheTest, StoresNoResultsWithoutAFolder) {
  Cache none;
  none.put(EntryKind::field, entry_key, 1);
  EXPECT_EQ(none.find<int>(EntryKind::field, entry_key), std::nullopt);
  EXPECT_EQ(none.get(EntryKind::field, entry_key, [] { return 2; }), 2);
  EXPECT_THAT(none.warnings(), IsEmpty());
  EXPECT_FALSE(fs::exists(folder()));
}

TEST_F(CacheTest, RecomputeOptionIgnoresAndReplacesEntries) {
  keep("old");
  Cache cache(folder(), true);
  EXPECT_EQ(found(cache), std::nullopt);
  cache.put(EntryKind::field, entry_key, std::string("new"));
  EXPECT_EQ(found(), "new");
}

TEST_F(CacheTest, ReplacesADamagedEntryWithOneWarning) {
  keep("value");
  const std::string bytes = text_of(entry());
  for (const std::string& damaged : {bytes.substr(0, bytes.size() / 2), std::string(), bytes + "x", std::string("x")}) {
    write_text(entry(), damaged);
    Cache cache(folder());
    EXPECT_EQ(found(cache), std::nullopt);
    EXPECT_EQ(found(cache), std::nullopt);
    EXPECT_THAT(cache.warnings(),
                ElementsAre("damaged cache entry, recomputed: " + entry().string() + " and 1 others"));
    keep("value");
    EXPECT_EQ(found(), "value");
  }
}

TEST_F(CacheTest, RecomputesAnEntryWhoseContentHasAnotherType) {
  keep("a text");
  Cache cache(folder());
  EXPECT_EQ(cache.get(EntryKind::field, entry_key, [] { return 0.5; }), 0.5);
  EXPECT_THAT(cache.warnings(), ElementsAre(HasSubstr("damaged cache entry")));
}

TEST_F(CacheTest, ReportsAFullDiskWithOneWarning) {
  Cache cache(folder());
  cache.put(EntryKind::field, entry_key, std::string("small"));
  rlimit before = {};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit = {1000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  cache.put(EntryKind::field, std::string(64, '1'), std::string(5000, 'x'));
  cache.put(EntryKind::field, std::string(64, '2'), std::string("small"));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(cache.warnings(),
              ElementsAre(testing::AllOf(HasSubstr("File too large"), HasSubstr("cache disabled for writing"))));
  EXPECT_EQ(found(cache), "small") << "what is there is still found";
  EXPECT_EQ(cache_contents(folder()).total().entries, 1U) << "nothing half-written, nothing more";
}

TEST_F(CacheTest, ReportsAFolderWithoutPermissionWithOneWarning) {
  keep("value");
  fs::permissions(folder().parent_path(), fs::perms(0755));
  fs::permissions(folder(), fs::perms(0555));
  Cache cache(folder());
  {
    const test::OrdinaryUser ordinary_user;
    cache.put(EntryKind::field, std::string(64, '1'), 1);
    cache.put(EntryKind::field, std::string(64, '2'), 2);
    EXPECT_EQ(found(cache), "value");
  }
  fs::permissions(folder(), fs::perms(0755));
  EXPECT_THAT(cache.warnings(), ElementsAre(HasSubstr("Permission denied")));
}

TEST_F(CacheTest, ReplacesANamedPipeInPlaceOfAnEntry) {
  fs::create_directories(entry().parent_path());
  ASSERT_EQ(::mkfifo(entry().c_str(), 0600), 0);
  Cache cache(folder());
  EXPECT_EQ(cache.find<std::string>(EntryKind::field, entry_key), std::nullopt);
  cache.put(EntryKind::field, entry_key, std::string("value"));
  EXPECT_EQ(cache.find<std::string>(EntryKind::field, entry_key), "value");
}

TEST_F(CacheTest, StillStoresResultsIfClearedDuringARun) {
  Cache cache(folder());
  std::jthread clearing([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      clear_cache(folder());
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  for (int i = 0; i < 300; ++i)
    cache.put(EntryKind::samples, std::string(61, 'c') + std::to_string(100 + i), std::string("x"));
  clearing.request_stop();
  clearing.join();
  cache.put(EntryKind::field, entry_key, std::string("value"));
  EXPECT_EQ(cache.find<std::string>(EntryKind::field, entry_key), "value");
  EXPECT_THAT(cache.warnings(), IsEmpty());
}

TEST_F(CacheTest, FolderCanBeSharedByConcurrentRuns) {
  const auto key_of = [](int i) { return std::string(62, 'c') + std::to_string(10 + i); };
  std::vector<std::jthread> threads;
  std::atomic<int> wrong = 0;
  for (int run = 0; run < 4; ++run) {
    threads.emplace_back([&] {
      Cache cache(folder());
      for (int i = 0; i < 80; ++i) {
        const std::string value(20'000, static_cast<char>('a' + i % 8));
        if (cache.get(EntryKind::field, key_of(i % 8), [&] { return value; }) != value) ++wrong;
        cache.put(EntryKind::field, key_of(i % 8), value);
      }
      wrong += static_cast<int>(cache.warnings().size());
    });
  }
  threads.clear();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(cache_contents(folder()).total().entries, 8U);
}

TEST(CacheEntryKinds, AreAllListedInTheManual) {
  const std::string manual = read_file_bytes(SHAPEGAUGE_SOURCE_FOLDER "/docs/manual/cache.md");
  for (const std::string_view kind : entry_kind_names) {
    EXPECT_THAT(manual, testing::HasSubstr(fmt::format("\n| `{}` | ", kind)));
  }
}

}  // namespace

}  // namespace shapegauge
