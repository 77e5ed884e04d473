// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"

namespace shapegauge {

/// Name of the file that marks a folder as a cache for backup programs (https://bford.info/cachedir/).
inline constexpr std::string_view cache_tag_name = "CACHEDIR.TAG";

/// Writes the file cache_tag_name to a cache folder if it is absent. Throws InputError if it cannot be written.
void write_cache_tag(const std::filesystem::path& cache);

/// Returns true if the folder has the tag file of write_cache_tag().
bool has_cache_tag(const std::filesystem::path& cache);

/// Returns the default cache folder: the environment variable SHAPEGAUGE_CACHE, or `shapegauge` in the cache folder of
/// the XDG Base Directory Specification (XDG_CACHE_HOME, or ~/.cache). Empty, which disables caching, if
/// SHAPEGAUGE_CACHE is empty or there is no home.
std::filesystem::path default_cache_folder();

/// Returns the maximum size of the cache after a run in bytes: the environment variable SHAPEGAUGE_CACHE_LIMIT, or 10
/// GB. Throws InputError for an invalid size.
std::uintmax_t cache_limit();

/// Parses a size in bytes: an integer, optionally followed by K, M, G or T (powers of 1000). Throws InputError for
/// anything else; `name` is the name of the setting in the message.
std::uintmax_t parse_size(std::string_view text, std::string_view name);

/// Returns the path of the file of a cache entry: `AB/CDEF.kind` in the cache folder for the key ABCDEF.
std::filesystem::path entry_path(const std::filesystem::path& cache, EntryKind kind, const std::string& key);

/// File in a cache folder: a cache entry, or one that is not completely written.
struct CacheFile {
  std::filesystem::path path;     ///< path of the file
  std::optional<EntryKind> kind;  ///< kind of the entry; none while it is being written or if that was interrupted
  std::uintmax_t bytes = 0;       ///< size of the file in bytes
  std::filesystem::file_time_type last_used;  ///< time when the entry was last written or read
};

/// Lists the files in the folder that caches have written. Empty if the folder does not exist. Throws InputError if it
/// cannot be read.
std::vector<CacheFile> cache_files(const std::filesystem::path& cache);

/// Numbers of cache entries and their sizes in bytes, per kind of entry (EntryKind).
struct CacheContents {
  /// Number of files of a cache and their total size.
  struct Amount {
    std::size_t entries = 0;   ///< number of files, one per cache entry
    std::uintmax_t bytes = 0;  ///< total size of the files in bytes
  };
  std::array<Amount, number_of_entry_kinds> by_kind;  ///< number and size of the entries of each EntryKind
  Amount unfinished;                                  ///< files being written, or left by killed runs

  [[nodiscard]] Amount total() const;  ///< sum over all kinds of entries and unfinished files
};

/// Returns the numbers and sizes of the entries in a cache folder, by kind. Throws InputError as cache_files() does.
CacheContents cache_contents(const std::filesystem::path& cache);

/// Removes all files that caches have written, except those that a run may be writing, and the folder if it is then
/// empty. Returns the numbers and sizes of the removed files. Throws InputError if a file cannot be removed.
CacheContents clear_cache(const std::filesystem::path& cache);

/// Removes unfinished files of killed runs, then the least recently used entries until the cache has at most `limit`
/// bytes. Skips files that cannot be read or removed.
void trim_cache(const std::filesystem::path& cache, std::uintmax_t limit);

}  // namespace shapegauge
