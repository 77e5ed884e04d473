#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

namespace shapegauge {

/// The bytes of a regular file, at most `limit` of them from its beginning. Throws InputError "cannot read <path>:
/// <reason>" where the file is absent, unreadable, not a regular file, or empty.
std::string read_file_bytes(const std::filesystem::path& path,
                            std::size_t limit = std::numeric_limits<std::size_t>::max());

}  // namespace shapegauge
