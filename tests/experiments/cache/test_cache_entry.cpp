#include <gmock/gmock.h>

#include "shapegauge/experiments/cache/cache_entry.h"

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
}  // namespace shapegauge
