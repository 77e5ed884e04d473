#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace shapegauge {

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

}  // namespace shapegauge
