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

/// The file that marks a folder as a cache for backup programs (https://bford.info/cachedir/).
inline constexpr std::string_view cache_tag_name = "CACHEDIR.TAG";

/// Writes that file, where it is absent. Throws InputError where it cannot be written.
void write_cache_tag(const std::filesystem::path& cache);

/// Whether the folder has the file that write_cache_tag() writes.
bool has_cache_tag(const std::filesystem::path& cache);

/// The folder of the cache where none is named: the environment variable SHAPEGAUGE_CACHE, or `shapegauge` in the cache
/// folder of the XDG Base Directory Specification (XDG_CACHE_HOME, or ~/.cache). Empty, which stands for no cache,
/// where SHAPEGAUGE_CACHE is set to nothing or there is no home.
std::filesystem::path default_cache_folder();

/// How many bytes the cache may hold after a run: the environment variable SHAPEGAUGE_CACHE_LIMIT, or 10 GB. Throws
/// InputError where the variable is not a size.
std::uintmax_t cache_limit();

/// A size in bytes: a whole number, or one followed by K, M, G or T (powers of 1000). Throws InputError for anything
/// else; `name` is what the message calls it.
std::uintmax_t parse_size(std::string_view text, std::string_view name);

/// The file of an entry in the folder of a cache: <two digits of the key>/<the others>.<kind>.
std::filesystem::path entry_path(const std::filesystem::path& cache, EntryKind kind, const std::string& key);

/// A file that a cache has written.
struct CacheFile {
  std::filesystem::path path;
  std::optional<EntryKind> kind;  ///< nothing: an entry that was never finished, or is being written
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type last_used;
};

/// Lists the files that caches have written in the folder, and no others. Empty where there is no such folder. Throws
/// InputError where it cannot be read.
std::vector<CacheFile> cache_files(const std::filesystem::path& cache);

/// How much a cache holds.
struct CacheContents {
  struct Amount {
    std::size_t entries = 0;
    std::uintmax_t bytes = 0;
  };
  std::array<Amount, number_of_entry_kinds> by_kind;
  Amount unfinished;

  [[nodiscard]] Amount total() const;
};

/// Counts what cache_files() finds.
CacheContents cache_contents(const std::filesystem::path& cache);

/// Removes all files that caches have written in the folder, and the folder if it is empty then. Returns what was
/// there. Throws InputError where something cannot be removed.
CacheContents clear_cache(const std::filesystem::path& cache);

/// Removes files that a killed run left unfinished, then the least recently used entries until the rest is within
/// the limit. Files that cannot be read or removed stay.
void trim_cache(const std::filesystem::path& cache, std::uintmax_t limit);

}  // namespace shapegauge
