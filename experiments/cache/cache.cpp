// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/cache/cache.h"

#include <fmt/format.h>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/cache/cache_folder.h"

namespace shapegauge {

namespace {

/// Returns everything before the content.
std::string header_of(EntryKind kind, std::string_view key, std::string_view content) {
  return fmt::format("shapegauge cache entry 1\n{} {}\n{} {}\n", name_of(kind), key, content.size(), sha256(content));
}

}  // namespace

std::string encode_entry(EntryKind kind, std::string_view key, std::string_view content) {
  return header_of(kind, key, content).append(content);
}

std::optional<std::string> decode_entry(EntryKind kind, std::string_view key, std::string_view bytes) {
  constexpr int lines = 3;
  std::size_t start = 0;
  for (int line = 0; line < lines; ++line) {
    const std::size_t end = bytes.find('\n', start);
    if (end == std::string_view::npos) return std::nullopt;
    start = end + 1;
  }
  const std::string_view content = bytes.substr(start);
  if (bytes.substr(0, start) != header_of(kind, key, content)) return std::nullopt;
  return std::string(content);
}

namespace fs = std::filesystem;

Cache::Cache(fs::path folder, bool recompute) : folder_(std::move(folder)), recompute_(recompute) {}

Cache::KeyLock::KeyLock(Cache& cache, std::string key) : cache_(&cache), key_(std::move(key)) {
  std::unique_lock lock(cache.mutex_);
  cache.key_unlocked_.wait(lock, [&] { return !cache.keys_in_progress_.contains(key_); });
  cache.keys_in_progress_.insert(key_);
}

Cache::KeyLock::~KeyLock() {
  {
    const std::scoped_lock lock(cache_->mutex_);
    cache_->keys_in_progress_.erase(key_);
  }
  cache_->key_unlocked_.notify_all();
}

std::optional<std::string> Cache::read(EntryKind kind, const std::string& key) {
  if (folder_.empty() || recompute_) return std::nullopt;
  const fs::path path = entry_path(folder_, kind, key);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::nullopt;
  try {
    if (auto content = decode_entry(kind, key, read_file_bytes(path))) {
      fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);  // trim_cache() goes by that
      return content;
    }
  } catch (const InputError&) {                           // empty, or not to be read
    if (!fs::exists(path, ignored)) return std::nullopt;  // another run has removed it just now
  }
  report_damaged(kind, key);
  return std::nullopt;
}

void Cache::write(EntryKind kind, const std::string& key, const std::string& content) {
  // Only results that take long to compute are worth flushing; others are quickly recomputed from them.
  const bool takes_long = kind == EntryKind::field || kind == EntryKind::samples || kind == EntryKind::comparison;
  constexpr int attempts = 10;  // another process may clear the cache meanwhile
  for (int attempt = 1; attempt <= attempts; ++attempt) {
    try {
      return write_entry(entry_path(folder_, kind, key), encode_entry(kind, key, content),
                         takes_long ? Flush::yes : Flush::no);
    } catch (const InputError& error) {
      if (attempt < attempts) continue;
      writable_ = false;
      const std::scoped_lock lock(mutex_);
      if (writing_error_.empty()) writing_error_ = error.what();
    }
  }
}

void Cache::write_entry(const fs::path& path, std::string_view bytes, Flush flush) const {
  std::error_code failure;
  fs::create_directories(path.parent_path(), failure);
  if (failure) throw InputError(fmt::format("cannot create {}: {}", path.parent_path().string(), failure.message()));
  write_cache_tag(folder_);
  // A pipe of that name would block.
  if (const fs::file_status found = fs::status(path, failure); fs::exists(found) && !fs::is_regular_file(found)) {
    fs::remove(path, failure);
  }
  write_file_atomically(path, bytes, flush);
}

void Cache::report_damaged(EntryKind kind, const std::string& key) {
  const std::scoped_lock lock(mutex_);
  if (damaged_++ == 0) first_damaged_ = entry_path(folder_, kind, key);
}

void Cache::count(EntryKind kind, bool hit) {
  const std::scoped_lock lock(mutex_);
  CacheUse& use = uses_.at(static_cast<std::size_t>(kind));
  ++(hit ? use.hits : use.computed);
}

CacheReport Cache::report() const {
  const std::scoped_lock lock(mutex_);
  return {.folder = folder_, .uses = uses_};
}

std::vector<std::string> Cache::warnings() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string> warnings;
  if (damaged_ > 0) {
    const std::string others = damaged_ > 1 ? fmt::format(" and {} others", damaged_ - 1) : "";
    warnings.push_back(fmt::format("damaged cache entry, recomputed: {}{}", first_damaged_.string(), others));
  }
  if (!writing_error_.empty()) {
    warnings.push_back(fmt::format("cache disabled for writing: {}; the results are complete", writing_error_));
  }
  return warnings;
}

}  // namespace shapegauge
