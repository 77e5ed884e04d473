#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace shapegauge {

/// Kind of cache entry.
enum class EntryKind {
  shape,         ///< findings of the preparation of a shape: diagnostics, scale, noise
  samples,       ///< weights of a shape's samples
  field,         ///< values of a field on a shape
  histogram,     ///< histogram of one field on one shape
  distances,     ///< distance matrix
  picture,       ///< picture of a shape, for the report
  view,          ///< interactive view of a shape, for the report
  features,      ///< features of a descriptor of one shape
  learnt,        ///< features that a descriptor has learnt from a data set
  segmentation,  ///< parts of a shape
  comparison,    ///< measurements on a shape of a comparison
  evaluation,    ///< evaluation of a submission to a leaderboard
};

inline constexpr std::size_t number_of_entry_kinds = 12;

/// Names of the kinds, which are also the extensions of the entries' files.
inline constexpr std::array<std::string_view, number_of_entry_kinds> entry_kind_names{
    "shape", "samples",  "field",  "histogram",    "distances",  "picture",
    "view",  "features", "learnt", "segmentation", "comparison", "evaluation"};

constexpr std::string_view name_of(EntryKind kind) { return entry_kind_names.at(static_cast<std::size_t>(kind)); }

/// Encodes the file of an entry: a line with the format, a line `<kind> <key>`, a line `<bytes> <SHA-256>` of the
/// content, and the content.
std::string encode_entry(EntryKind kind, std::string_view key, std::string_view content);

/// Decodes the file of an entry. Nothing if it is corrupt: another length, checksum or key.
std::optional<std::string> decode_entry(EntryKind kind, std::string_view key, std::string_view bytes);

/// Numbers of results of one kind found in the cache and computed.
struct CacheUse {
  std::size_t hits = 0;
  std::size_t computed = 0;
};

/// Use of the cache by a run.
struct CacheReport {
  std::filesystem::path folder;  ///< empty if there was no cache
  std::array<CacheUse, number_of_entry_kinds> uses;
};

/// Store of results on disk. The key of a result covers everything that the result depends on
/// (signatures/cache_records.h).
///
/// Every entry is one file, written atomically and verified on reading. Safe for concurrent use by several threads and
/// processes. Disk errors never fail a run: missing results are computed, results that cannot be stored are not, and
/// warnings() reports it.
class Cache {
 public:
  /// Disables caching: finds nothing and stores nothing.
  Cache() = default;
  /// Opens a cache in the folder, which is created with the first entry; an empty path disables caching. With
  /// `recompute`, lookups find nothing, and computed results replace existing entries.
  explicit Cache(std::filesystem::path folder, bool recompute = false);

  /// Looks up the value under the key and converts it by `read`. Nothing if there is none or it is damaged, which adds
  /// a warning. `read` throws nlohmann::json::exception for a malformed value.
  template <typename Read>
  auto lookup(EntryKind kind, const std::string& key, const Read& read)
      -> std::optional<std::invoke_result_t<Read, const nlohmann::json&>> {
    const std::optional<nlohmann::json> value = lookup_value(kind, key);
    if (!value) return std::nullopt;
    try {
      return read(*value);
    } catch (const nlohmann::json::exception&) {
      report_damaged(kind, key);
      return std::nullopt;
    }
  }

  /// Stores a value under the key. Binary values and numbers are restored bit by bit.
  void store(EntryKind kind, const std::string& key, const nlohmann::json& value);

  /// Counts a result as found in the cache or as computed, for the report.
  void count(EntryKind kind, bool hit);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] CacheReport report() const;
  /// Returns one line for each problem: damaged entries, a folder that cannot be written.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  std::optional<nlohmann::json> lookup_value(EntryKind kind, const std::string& key);
  void report_damaged(EntryKind kind, const std::string& key);

  std::filesystem::path folder_;
  bool recompute_ = false;
  std::atomic<bool> writable_ = true;
  mutable std::mutex mutex_;  ///< guards what follows
  std::array<CacheUse, number_of_entry_kinds> uses_{};
  std::size_t damaged_ = 0;
  std::filesystem::path first_damaged_;
  std::string writing_error_;
};

}  // namespace shapegauge
