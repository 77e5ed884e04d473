#pragma once

#include <filesystem>
#include <string_view>

namespace shapegauge {

/// The file that tells programs for backups that a folder is a cache (https://bford.info/cachedir/).
inline constexpr std::string_view cache_tag_name = "CACHEDIR.TAG";

/// Writes that file, where it is absent. Throws InputError where it cannot be written.
void write_cache_tag(const std::filesystem::path& cache);

/// Whether the folder has the file that write_cache_tag() writes.
bool has_cache_tag(const std::filesystem::path& cache);

}  // namespace shapegauge
