// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/cache/codec.h"

namespace shapegauge {

/// Kind of cache entry.
enum class EntryKind {
  shape,         ///< diagnostics, scale and noise of a shape (ShapeFacts)
  samples,       ///< surface area that each sample of a shape represents
  field,         ///< values of a field on a shape
  distances,     ///< matrix of distances between signatures
  picture,       ///< picture of a shape, for the report
  view,          ///< interactive view of a shape, for the report
  features,      ///< features of a descriptor of one shape
  learnt,        ///< features that a descriptor has learnt from a data set
  segmentation,  ///< segmentation of a shape into parts
  comparison,    ///< measurements of one shape in a shape comparison
  evaluation,    ///< scores of a submission to a leaderboard, or of rows of a distance matrix
};

inline constexpr std::size_t number_of_entry_kinds = 11;  ///< number of values of EntryKind

/// Names of the kinds of cache entries, in the order of EntryKind; also the extensions of the entries' files.
inline constexpr std::array<std::string_view, number_of_entry_kinds> entry_kind_names{
    "shape",    "samples", "field",        "distances",  "picture",   "view",
    "features", "learnt",  "segmentation", "comparison", "evaluation"};

/// Returns the name of a kind of cache entry (entry_kind_names).
constexpr std::string_view name_of(EntryKind kind) { return entry_kind_names.at(static_cast<std::size_t>(kind)); }

/// Returns the bytes of the file of a cache entry: a line with the format, a line `<kind> <key>`, a line `<bytes>
/// <SHA-256>` of the content, and the content.
std::string encode_entry(EntryKind kind, std::string_view key, std::string_view content);

/// Returns the content of a cache entry from the bytes of its file. Nothing if the file is corrupt: its kind, key,
/// length or checksum differs.
std::optional<std::string> decode_entry(EntryKind kind, std::string_view key, std::string_view bytes);

/// Numbers of results of one EntryKind found in the cache and computed.
struct CacheUse {
  std::size_t hits = 0;      ///< number of results found in the cache
  std::size_t computed = 0;  ///< number of results computed
};

/// Numbers of results that a run found in the cache and computed, per kind of cache entry (EntryKind).
struct CacheReport {
  std::filesystem::path folder;                      ///< folder of the cache; empty if the run had no cache
  std::array<CacheUse, number_of_entry_kinds> uses;  ///< results found and computed, per EntryKind, in its order
};

/// Store of results on disk. The key of a result covers everything that the result depends on
/// (signatures/cache_keys.h); values are encoded by members() (codec.h).
///
/// Every entry is one file, written atomically and verified on reading. Safe for concurrent use by several threads and
/// processes. Disk errors never fail a run: missing results are computed, results that cannot be stored are not, and
/// warnings() reports it.
class Cache {
 public:
  /// Disables caching: finds nothing and stores nothing.
  Cache() = default;
  /// Opens a cache in the folder, which is created with the first entry; an empty path disables caching. With
  /// `recompute`, results are not found, and computed ones replace existing entries.
  explicit Cache(std::filesystem::path folder, bool recompute = false);

  /// Returns the result under the key: found, or computed and stored. Threads that request the same key compute it
  /// once. Throws the errors of `compute`, whose result is then not stored.
  template <typename Compute>
  auto get(EntryKind kind, const std::string& key, const Compute& compute) {
    using Value = std::decay_t<std::invoke_result_t<Compute>>;
    const KeyLock turn(*this, key);
    std::optional<Value> found = find<Value>(kind, key);
    if (found) return *std::move(found);
    Value value = compute();
    put(kind, key, value);
    return value;
  }

  /// Returns the result stored under the key. Nothing if none is stored, or if its file is damaged, which adds a
  /// warning.
  template <typename Value>
  std::optional<Value> find(EntryKind kind, const std::string& key) {
    const std::optional<std::string> bytes = read(kind, key);
    if (!bytes) return std::nullopt;
    try {
      auto value = decode<Value>(*bytes);
      count(kind, true);
      return value;
    } catch (const DamagedBytes&) {
      report_damaged(kind, key);
      return std::nullopt;
    }
  }

  /// Counts a result as computed, and stores it under the key unless caching is disabled or the folder not writable.
  template <typename Value>
  void put(EntryKind kind, const std::string& key, const Value& value) {
    count(kind, false);
    if (!folder_.empty() && writable_) write(kind, key, encode(value));
  }

  /// Returns the folder of the cache; empty if caching is disabled.
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Returns the numbers of results found in the cache and computed since this object was created.
  [[nodiscard]] CacheReport report() const;
  /// Returns one line for each problem of the cache: damaged entries, a folder that cannot be written.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  /// Lock on a key for the lifetime of the object: no other thread computes the result with this key.
  class KeyLock {
   public:
    KeyLock(Cache& cache, std::string key);  ///< waits until no other thread has locked the key
    KeyLock(const KeyLock&) = delete;
    KeyLock& operator=(const KeyLock&) = delete;
    KeyLock(KeyLock&&) = delete;
    KeyLock& operator=(KeyLock&&) = delete;
    ~KeyLock();  ///< unlocks the key

   private:
    Cache* cache_;     ///< cache of the locked key; not null
    std::string key_;  ///< locked key
  };

  std::optional<std::string> read(EntryKind kind, const std::string& key);  ///< reads a valid entry; nothing otherwise
  void write(EntryKind kind, const std::string& key, const std::string& content);  ///< writes an entry to its file
  void write_entry(const std::filesystem::path& path, std::string_view bytes, Flush flush) const;
  void count(EntryKind kind, bool hit);  ///< counts a result found in the cache (hit) or computed
  void report_damaged(EntryKind kind, const std::string& key);  ///< adds a warning about a damaged entry

  std::filesystem::path folder_;                        ///< folder of the cache; empty if caching is disabled
  bool recompute_ = false;                              ///< true to replace existing entries, not read them
  std::atomic<bool> writable_ = true;                   ///< false after an entry could not be written
  mutable std::mutex mutex_;                            ///< guards the members declared below it
  std::condition_variable key_unlocked_;                ///< signalled when a key leaves keys_in_progress_
  std::set<std::string> keys_in_progress_;              ///< keys of results that a thread is computing
  std::array<CacheUse, number_of_entry_kinds> uses_{};  ///< results found and computed, per EntryKind, in its order
  std::size_t damaged_ = 0;                             ///< number of damaged cache entries found
  std::filesystem::path first_damaged_;                 ///< file of the first damaged entry; empty if none
  std::string writing_error_;                           ///< message of the first failed write; empty if none
};

}  // namespace shapegauge
