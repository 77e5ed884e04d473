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

/// What an entry of the cache holds.
enum class EntryKind {
  shape,         ///< what was found of a shape while it was prepared: diagnostics, scale, noise
  samples,       ///< the weights of a shape's samples
  field,         ///< the values of a field on a shape
  histogram,     ///< of one field on one shape
  distances,     ///< a distance matrix
  picture,       ///< of a shape, for the report
  view,          ///< of a shape, to be turned in the report
  features,      ///< of a descriptor, of one shape
  learnt,        ///< what a descriptor has learnt from a data set
  segmentation,  ///< the parts of a shape
  evaluation,    ///< of a submission to a leaderboard
};

inline constexpr std::size_t number_of_entry_kinds = 11;

/// The kinds' names, which are also the extensions of the entries' files.
inline constexpr std::array<std::string_view, number_of_entry_kinds> entry_kind_names{
    "shape", "samples",  "field",  "histogram",    "distances", "picture",
    "view",  "features", "learnt", "segmentation", "evaluation"};

constexpr std::string_view name_of(EntryKind kind) { return entry_kind_names.at(static_cast<std::size_t>(kind)); }

/// The bytes of the file of an entry: a line that names the format, a line `<kind> <key>`, a line `<bytes> <SHA-256>`
/// of what follows, and that.
std::string encode_entry(EntryKind kind, std::string_view key, std::string_view content);

/// What the file of an entry holds; nothing where a byte of it is not what was written: another length, another
/// checksum, another key.
std::optional<std::string> decode_entry(EntryKind kind, std::string_view key, std::string_view bytes);

/// How many results of one kind a run found in the cache, and how many it computed.
struct CacheUse {
  std::size_t hits = 0;
  std::size_t computed = 0;
};

/// How a run used the cache.
struct CacheReport {
  std::filesystem::path folder;  ///< empty: there was none
  std::array<CacheUse, number_of_entry_kinds> uses;
};

/// A store of results on disk, each under a key that stands for all that the result depends on
/// (runner/cache_records.h).
///
/// Every entry is one file, written as a whole or not at all and verified when it is read. Safe to use from several
/// threads and several processes. Disk errors never fail a run: what cannot be looked up is computed, what cannot be
/// stored is not, and warnings() says so.
class Cache {
 public:
  /// No cache: finds nothing and stores nothing.
  Cache() = default;
  /// A cache in the folder, which is made when the first entry is stored; of an empty path: none. With `recompute` it
  /// finds nothing, and stores what is computed in place of what was there.
  explicit Cache(std::filesystem::path folder, bool recompute = false);

  /// Looks up the value under the key, as `read` makes it; nothing where there is none or where it is damaged, which is
  /// a warning. `read` throws nlohmann::json::exception for a value that is not of its form.
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

  /// Stores a value under the key. Binary values and numbers come back bit by bit.
  void store(EntryKind kind, const std::string& key, const nlohmann::json& value);

  /// Counts a result as found in the cache or as computed, for the report.
  void count(EntryKind kind, bool hit);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] CacheReport report() const;
  /// One line each, for damaged entries and for a folder that cannot be written to.
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
