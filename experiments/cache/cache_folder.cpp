// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/cache/cache_folder.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <fmt/format.h>
#include <limits>
#include <system_error>

#include "shapegauge/core/base/environment.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view tag =
    "Signature: 8a477f597d28d172789f06886806bc55\n"
    "# This folder is a cache of shapegauge; see `shapegauge cache --help`. It can be removed at any time.\n";

/// Returns the absolute path in an environment variable; empty if there is none. The XDG specification ignores relative
/// paths.
fs::path folder_in(const std::string& name) {
  const fs::path path = environment_variable(name).value_or("");
  return path.is_absolute() ? path : fs::path();
}

constexpr std::size_t digits_of_folder = 2;
constexpr std::size_t digits_of_key = 64;

bool is_hexadecimal(std::string_view text) {
  return text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

bool is_entry_folder(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return name.size() == digits_of_folder && is_hexadecimal(name) && entry.is_directory() && !entry.is_symlink();
}

/// Returns the file if its name is one of a cache entry: <62 digits>.<kind>, with ".<number>-<number>.part" while it is
/// being written.
std::optional<CacheFile> cache_file(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  constexpr std::size_t digits = digits_of_key - digits_of_folder;
  if (name.size() < digits + 2 || !is_hexadecimal(name.substr(0, digits)) || name[digits] != '.') return std::nullopt;
  const std::string_view rest = std::string_view(name).substr(digits + 1);
  const std::string_view kind = rest.substr(0, rest.find('.'));
  const auto known = std::ranges::find(entry_kind_names, kind);
  const bool unfinished = rest.size() > kind.size() && rest.ends_with(".part");
  if (known == entry_kind_names.end() || (rest.size() > kind.size() && !unfinished)) return std::nullopt;
  std::error_code gone;  // another run may have removed it since
  CacheFile file{.path = entry.path(), .kind = {}, .bytes = entry.file_size(gone), .last_used = {}};
  if (!gone) file.last_used = entry.last_write_time(gone);
  if (gone) return std::nullopt;
  if (!unfinished) file.kind = static_cast<EntryKind>(known - entry_kind_names.begin());
  return file;
}

CacheContents contents_of(const std::vector<CacheFile>& files) {
  CacheContents contents;
  for (const CacheFile& file : files) {
    CacheContents::Amount& amount =
        file.kind ? contents.by_kind.at(static_cast<std::size_t>(*file.kind)) : contents.unfinished;
    ++amount.entries;
    amount.bytes += file.bytes;
  }
  return contents;
}

/// Whether another run may be writing the file; after an hour that run no longer exists.
bool may_be_written(const CacheFile& file) {
  return !file.kind && file.last_used > fs::file_time_type::clock::now() - std::chrono::hours(1);
}

/// Removes empty folders of entries, the tag if no other folder is left, and the cache's folder.
void remove_empty_folders(const fs::path& cache) {
  std::error_code not_empty;
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(cache, not_empty)) {
    if (is_entry_folder(entry)) folders.push_back(entry.path());
  }
  for (const fs::path& folder : folders) fs::remove(folder, not_empty);
  if (has_cache_tag(cache)) fs::remove(cache / cache_tag_name, not_empty);
  fs::remove(cache, not_empty);
}

}  // namespace

void write_cache_tag(const std::filesystem::path& cache) {
  if (!std::filesystem::exists(cache / cache_tag_name)) write_file_atomically(cache / cache_tag_name, tag);
}

bool has_cache_tag(const std::filesystem::path& cache) {
  try {
    return read_file_bytes(cache / cache_tag_name, tag.size() + 1) == tag;
  } catch (const InputError&) {
    return false;
  }
}

fs::path default_cache_folder() {
  if (const auto named = environment_variable("SHAPEGAUGE_CACHE")) return *named;
  if (const fs::path caches = folder_in("XDG_CACHE_HOME"); !caches.empty()) return caches / "shapegauge";
  const fs::path home = folder_in("HOME");
  return home.empty() ? fs::path() : home / ".cache" / "shapegauge";
}

std::uintmax_t parse_size(std::string_view text, std::string_view name) {
  std::uintmax_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  constexpr std::string_view units = "KMGT";
  std::uintmax_t factor = 1;
  if (unit.size() == 1 && units.find(unit.front()) != std::string_view::npos) {
    for (std::size_t i = 0; i <= units.find(unit.front()); ++i) factor *= 1000;
  }
  const bool known_unit = unit.empty() || factor > 1;
  if (error != std::errc() || !known_unit || number > std::numeric_limits<std::uintmax_t>::max() / factor) {
    throw InputError(fmt::format("{} must be a size such as 500M or 10G, not \"{}\"", name, printable(text, 100)));
  }
  return number * factor;
}

std::uintmax_t cache_limit() {
  const std::string name = "SHAPEGAUGE_CACHE_LIMIT";
  return parse_size(environment_variable(name).value_or("10G"), name);
}

fs::path entry_path(const fs::path& cache, EntryKind kind, const std::string& key) {
  return cache / key.substr(0, digits_of_folder) / fmt::format("{}.{}", key.substr(digits_of_folder), name_of(kind));
}

std::vector<CacheFile> cache_files(const fs::path& cache) try {
  std::vector<CacheFile> files;
  if (!fs::exists(cache)) return files;
  for (const fs::directory_entry& folder : fs::directory_iterator(cache)) {
    if (!is_entry_folder(folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (auto file = cache_file(entry)) files.push_back(std::move(*file));
    }
  }
  return files;
} catch (const fs::filesystem_error& error) {
  throw InputError(fmt::format("cannot read the cache {}: {}", cache.string(), error.code().message()));
}

CacheContents::Amount CacheContents::total() const {
  Amount sum = unfinished;
  for (const Amount& amount : by_kind) {
    sum.entries += amount.entries;
    sum.bytes += amount.bytes;
  }
  return sum;
}

CacheContents cache_contents(const fs::path& cache) { return contents_of(cache_files(cache)); }

CacheContents clear_cache(const fs::path& cache) {
  std::vector<CacheFile> files = cache_files(cache);
  std::erase_if(files, may_be_written);
  for (const CacheFile& file : files) {
    std::error_code failure;
    fs::remove(file.path, failure);
    if (failure) throw InputError(fmt::format("cannot remove {}: {}", file.path.string(), failure.message()));
  }
  remove_empty_folders(cache);
  return contents_of(files);
}

void trim_cache(const fs::path& cache, std::uintmax_t limit) {
  std::vector<CacheFile> files;
  try {
    files = cache_files(cache);
  } catch (const InputError&) {
    return;  // reported when it was read or written
  }
  std::ranges::sort(files, {}, &CacheFile::last_used);
  std::uintmax_t bytes = contents_of(files).total().bytes;
  for (const CacheFile& file : files) {
    const bool remove = file.kind ? bytes > limit : !may_be_written(file);
    std::error_code stays;
    if (remove && fs::remove(file.path, stays)) bytes -= file.bytes;
  }
}

}  // namespace shapegauge
