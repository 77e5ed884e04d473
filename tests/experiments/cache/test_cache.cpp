#include <atomic>
#include <bit>
#include <cmath>
#include <csignal>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <limits>
#include <sys/resource.h>
#include <thread>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

const std::string key(64, 'a');
const std::string content("values\0\n\xff and more", 18);

TEST(CacheEntry, ComesBackAsItWas) {
  for (const std::string& one : {content, std::string(), std::string(5000, '\n')}) {
    EXPECT_EQ(decode_entry(EntryKind::field, key, encode_entry(EntryKind::field, key, one)), one);
  }
}

TEST(CacheEntry, EveryFlippedBitIsFound) {
  const std::string bytes = encode_entry(EntryKind::histogram, key, content);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(static_cast<unsigned char>(damaged[i]) ^ (1U << bit));
      EXPECT_EQ(decode_entry(EntryKind::histogram, key, damaged), std::nullopt) << "byte " << i << " bit " << bit;
    }
  }
}

TEST(CacheEntry, EveryTruncationAndEveryAdditionIsFound) {
  const std::string bytes = encode_entry(EntryKind::shape, key, content);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_EQ(decode_entry(EntryKind::shape, key, bytes.substr(0, size)), std::nullopt) << size;
  }
  EXPECT_EQ(decode_entry(EntryKind::shape, key, bytes + '\0'), std::nullopt);
}

TEST(CacheEntry, AnotherEntryIsNotTakenForIt) {
  const std::string bytes = encode_entry(EntryKind::shape, key, content);
  EXPECT_EQ(decode_entry(EntryKind::field, key, bytes), std::nullopt);
  EXPECT_EQ(decode_entry(EntryKind::shape, std::string(64, 'b'), bytes), std::nullopt);
}

}  // namespace

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::text_of;
using test::write_text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string entry_key(64, '0');

json same(const json& value) { return value; }

class CacheTest : public testing::Test {
 protected:
  [[nodiscard]] fs::path folder() const { return folder_.path() / "cache"; }
  [[nodiscard]] fs::path entry() const { return entry_path(folder(), EntryKind::field, entry_key); }
  void keep(const json& value) const { Cache(folder()).store(EntryKind::field, entry_key, value); }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(CacheTest, AnotherRunFindsWhatOneHasKept) {
  keep({{"a", 1}});
  Cache cache(folder());
  EXPECT_EQ(cache.lookup(EntryKind::field, entry_key, same), (json{{"a", 1}}));
  EXPECT_EQ(cache.lookup(EntryKind::shape, entry_key, same), std::nullopt);
  EXPECT_EQ(cache.lookup(EntryKind::field, std::string(64, '1'), same), std::nullopt);
  EXPECT_THAT(cache.warnings(), IsEmpty());
}

TEST_F(CacheTest, NumbersComeBackBitByBit) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double number : {0.1, -0.0, 1e-310, 1.0 / 3, infinity, -infinity, std::nextafter(0.5, 1)}) {
    keep(number);
    const auto found = Cache(folder()).lookup(EntryKind::field, entry_key, same).value().get<double>();
    EXPECT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(number)) << number;
  }
  keep(std::nan(""));
  EXPECT_TRUE(std::isnan(Cache(folder()).lookup(EntryKind::field, entry_key, same).value().get<double>()));
}

TEST_F(CacheTest, WithoutAFolderNothingIsKept) {
  Cache none;
  none.store(EntryKind::field, entry_key, 1);
  EXPECT_EQ(none.lookup(EntryKind::field, entry_key, same), std::nullopt);
  EXPECT_THAT(none.warnings(), IsEmpty());
  EXPECT_FALSE(fs::exists(folder()));
}

TEST_F(CacheTest, RecomputingFindsNothingAndKeepsWhatIsNew) {
  keep("old");
  Cache cache(folder(), true);
  EXPECT_EQ(cache.lookup(EntryKind::field, entry_key, same), std::nullopt);
  cache.store(EntryKind::field, entry_key, "new");
  EXPECT_EQ(Cache(folder()).lookup(EntryKind::field, entry_key, same), "new");
}

TEST_F(CacheTest, ADamagedEntryIsOneWarningAndIsReplaced) {
  keep("value");
  const std::string bytes = text_of(entry());
  for (const std::string& damaged : {bytes.substr(0, bytes.size() / 2), std::string(), bytes + "x", std::string("x")}) {
    write_text(entry(), damaged);
    Cache cache(folder());
    EXPECT_EQ(cache.lookup(EntryKind::field, entry_key, same), std::nullopt);
    EXPECT_EQ(cache.lookup(EntryKind::field, entry_key, same), std::nullopt);
    EXPECT_THAT(cache.warnings(),
                ElementsAre("damaged cache entry, recomputed: " + entry().string() + " and 1 others"));
    cache.store(EntryKind::field, entry_key, "value");
    EXPECT_EQ(Cache(folder()).lookup(EntryKind::field, entry_key, same), "value");
  }
}

TEST_F(CacheTest, ARecordOfAnotherFormIsDamagedToo) {
  keep("a text");
  Cache cache(folder());
  EXPECT_EQ(cache.lookup(EntryKind::field, entry_key, [](const json& value) { return value.get<double>(); }),
            std::nullopt);
  EXPECT_THAT(cache.warnings(), ElementsAre(HasSubstr("damaged cache entry")));
}

TEST_F(CacheTest, UsesAreCounted) {
  Cache cache(folder());
  cache.count(EntryKind::field, true);
  cache.count(EntryKind::field, true);
  cache.count(EntryKind::field, false);
  const CacheUse use = cache.report().uses.at(static_cast<std::size_t>(EntryKind::field));
  EXPECT_EQ(use.hits, 2U);
  EXPECT_EQ(use.computed, 1U);
}

TEST_F(CacheTest, AFullDiskIsOneWarning) {
  Cache cache(folder());
  cache.store(EntryKind::field, entry_key, "small");
  rlimit before = {};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit = {1000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  cache.store(EntryKind::field, std::string(64, '1'), std::string(5000, 'x'));
  cache.store(EntryKind::field, std::string(64, '2'), "small");
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(cache.warnings(),
              ElementsAre(testing::AllOf(HasSubstr("File too large"), HasSubstr("cache disabled for writing"))));
  EXPECT_EQ(cache.lookup(EntryKind::field, entry_key, same), "small") << "what is there is still found";
  EXPECT_EQ(cache_contents(folder()).total().entries, 1U) << "nothing half-written, nothing more";
}

TEST_F(CacheTest, AFolderWithoutPermissionIsOneWarning) {
  keep("value");
  fs::permissions(folder().parent_path(), fs::perms(0755));
  fs::permissions(folder(), fs::perms(0555));
  Cache cache(folder());
  {
    const test::OrdinaryUser ordinary_user;
    cache.store(EntryKind::field, std::string(64, '1'), 1);
    cache.store(EntryKind::field, std::string(64, '2'), 2);
    EXPECT_EQ(cache.lookup(EntryKind::field, entry_key, same), "value");
  }
  fs::permissions(folder(), fs::perms(0755));
  EXPECT_THAT(cache.warnings(), ElementsAre(HasSubstr("Permission denied")));
}

TEST_F(CacheTest, SeveralRunsShareAFolder) {
  const auto key_of = [](int i) { return std::string(62, 'c') + std::to_string(10 + i); };
  std::vector<std::jthread> threads;
  std::atomic<int> wrong = 0;
  for (int run = 0; run < 4; ++run) {
    threads.emplace_back([&] {
      Cache cache(folder());
      for (int i = 0; i < 80; ++i) {
        const json value(std::string(20'000, static_cast<char>('a' + i % 8)));
        if (const auto found = cache.lookup(EntryKind::field, key_of(i % 8), same); found && *found != value) ++wrong;
        cache.store(EntryKind::field, key_of(i % 8), value);
      }
      wrong += static_cast<int>(cache.warnings().size());
    });
  }
  threads.clear();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(cache_contents(folder()).total().entries, 8U);
}

TEST(EntryKinds, AreAllInTheManual) {
  const std::string manual = read_file_bytes(SHAPEGAUGE_CACHE_GUIDE);
  for (const std::string_view kind : entry_kind_names) {
    EXPECT_THAT(manual, testing::HasSubstr(fmt::format("\n| `{}` | ", kind)));
  }
}

}  // namespace

}  // namespace shapegauge
